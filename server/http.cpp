// HeaderGate accepts and holds connections, threads answer one request of each: what a refusal leaves unread is never
// taken for the next. cpp-httplib would let clients hold threads or memory, so it never sees a socket (see
// httplib_adapter.h). It limits neither chunked nor compressed bodies, so bytes are counted in Connection, and of the
// header it gets the length of the body only (see header_block.h; Accept-Encoding would cost brotli's best compression,
// many Ranges a multiple of the answer).
#include "server/http.h"

#include <atomic>
#include <optional>
#include <string>

#include "server/client_of.h"
#include "server/cors.h"
#include "server/header_block.h"
#include "server/header_gate.h"
#include "server/httplib_adapter.h"
#include "server/listening.h"
#include "server/memory.h"
#include "server/negotiation.h"
#include "server/request_body.h"
#include "server/workers.h"

namespace coapt {
namespace {

// What cpp-httplib is told of a header.
std::string library_header(const HeaderBlock& header) {
  std::string text = header.request_line + "\r\n";
  for (const char* name : {"content-length", "transfer-encoding"}) {
    if (header.fields.contains(name))
      text += std::string(name) + ": " + field(header, name) + "\r\n";
  }
  return text + "\r\n";
}

std::string_view method_name(std::string_view method) {
  for (const std::string_view known :
       {"GET", "HEAD", "POST", "PUT", "PATCH", "DELETE", "OPTIONS"}) {
    if (known == method) return known;
  }
  return "other";
}

}  // namespace

struct HttpServer::Inside {
  Inside(const HttpLimits& given, const Routes& their_routes, const Access& their_access,
         Observe their_observe);

  void admit(Arrival arrival);
  std::string serve(Connection& connection, std::string_view header_bytes,
                    const std::string& client, Clock::time_point since);
  Answer answer(Request& request, BodySource& body, const Route*& route);
  Answer full_answer(Request& request, BodySource& body, const Route*& route);
  Answer counted(Answer answer);

  const HttpLimits limits;
  const Routes& routes;
  const Access& access;
  const Observe observe;
  Descriptor listening;
  std::atomic<int> streams = 0;
  std::atomic<bool> stopping = false;
  HeaderGate gate;
  Workers workers;
};

namespace {

GateLimits gate_limits(const HttpLimits& limits) {
  GateLimits gate;
  gate.header_bytes = limits.header_bytes;
  gate.header_seconds = limits.header_seconds;
  gate.answer_seconds = limits.answer_seconds;
  gate.linger_bytes = 2 * limits.body_bytes + gate.linger_bytes;
  gate.connections = limits.connections;
  return gate;
}

}  // namespace

HttpServer::Inside::Inside(const HttpLimits& given, const Routes& their_routes,
                           const Access& their_access, Observe their_observe)
    : limits(given),
      routes(their_routes),
      access(their_access),
      observe(std::move(their_observe)),
      gate(
          gate_limits(given), [this](Arrival arrival) { admit(std::move(arrival)); },
          [this](int status) {
            observe({"other", "none", status, 0.0});
          }),
      workers(given.requests) {}

Answer HttpServer::Inside::answer(Request& request, BodySource& body, const Route*& route) {
  if (request.method == "HEAD") request.method = "GET";
  request.headers = body.header.fields;
  request.abandoned = [this, &body] { return stopping || body.connection.client_gone(); };
  if (std::optional<Answer> preflight = answer_preflight(access, request))
    return *std::move(preflight);
  return for_origin(access, request, negotiated(full_answer(request, body, route), request));
}

Answer HttpServer::Inside::full_answer(Request& request, BodySource& body, const Route*& route) {
  if (std::optional<Answer> refusal = refuse(access, request)) return *std::move(refusal);
  Found found = find_route(routes, request);
  if (found.route == nullptr) return std::move(found.refusal);
  route = found.route;
  request.parameters = std::move(found.parameters);
  if (brings_body(request.method + ' ')) {
    if (std::optional<Answer> refusal =
            refuse_body(body.header, limits.body_bytes, route->takes_form))
      return *std::move(refusal);
    const MayRunOut hungry;
    if (std::optional<Answer> refusal = read_body(body, limits, request.body))
      return *std::move(refusal);
  }
  return counted(route->endpoint(request));
}

/// A stream holds its place until it is destroyed.
Answer HttpServer::Inside::counted(Answer answer) {
  auto* stream = std::get_if<Stream>(&answer.body);
  if (stream == nullptr) return answer;
  const std::shared_ptr<void> place(nullptr, [this](void*) { --streams; });
  if (++streams > limits.streams) return problem(503, ErrorCode::Busy, "too many streams are open");
  stream->next = [place, next = std::move(stream->next)](const Send& send) { return next(send); };
  return answer;
}

void HttpServer::Inside::admit(Arrival arrival) {
  const bool body = brings_body(arrival.bytes);
  const std::string client = client_of(
      arrival.socket.number(),
      limits.behind_proxy ? std::string_view(arrival.bytes).substr(0, arrival.header_bytes) : "");
  // std::function wants what can be copied.
  const auto shared = std::make_shared<Arrival>(std::move(arrival));
  workers.add(body, client, [this, shared, client] {
    const std::string header = shared->bytes.substr(0, shared->header_bytes);
    Connection connection(std::move(shared->socket), shared->bytes.substr(shared->header_bytes),
                          gate.given_up());
    std::string answer;
    try {
      answer = serve(connection, header, client, shared->since);
    } catch (...) {
      // Out of memory, for instance: the client gets an end without an answer, the others are served.
    }
    gate.give_back(connection.release(), std::move(answer));
    refill_memory_reserve();
  });
}

/// The answer, as far as it has not been sent.
std::string HttpServer::Inside::serve(Connection& connection, std::string_view header_bytes,
                                      const std::string& client, Clock::time_point since) {
  const std::optional<HeaderBlock> header = parse_header(header_bytes);
  if (!header) {
    observe({"other", "none", 400, 0.0});
    return as_http(problem(400, ErrorCode::Unsupported, "the header cannot be read"));
  }
  BodySource body{connection, *header};
  const Route* route = nullptr;
  std::string_view method = "other";
  Wire wire;
  wire.header = library_header(*header);
  wire.read = [&](char* to, std::size_t size) { return body.take(to, size); };
  wire.send = [&](std::string_view part) { return connection.send(part, limits.answer_seconds); };
  wire.wants_more = [&] { return !stopping && !connection.client_gone(); };
  Served served = serve_request(wire, [&](Request request, const ReadBody& read) {
    method = method_name(request.method);
    request.client = client;
    body.decoded = read;
    return answer(request, body, route);
  });
  const std::chrono::duration<double> seconds = Clock::now() - since;
  observe({method, route == nullptr ? "none" : route->path, served.status, seconds.count()});
  return std::move(served.unsent);
}

HttpServer::HttpServer(const HttpLimits& limits, const Routes& routes, const Access& access,
                       Observe observe)
    : inside_(std::make_unique<Inside>(limits, routes, access, std::move(observe))) {}

HttpServer::~HttpServer() = default;

Expected<int> HttpServer::bind(const std::string& host, int port) {
  Expected<Listening> listening = listen_on(host, port);
  if (!listening) return listening.errors();
  inside_->listening = std::move(listening->socket);
  return listening->port;
}

bool HttpServer::run() { return inside_->gate.run(std::move(inside_->listening)); }

void HttpServer::stop() {
  inside_->stopping = true;
  inside_->gate.stop();
}

HttpLoad HttpServer::load() const {
  return {inside_->gate.connections(), inside_->workers.busy(), inside_->streams};
}

}  // namespace coapt
