// cpp-httplib 0.11.4 binds, reads the request line and the body, and lays the answer out. The rest would let clients
// hold threads or memory, so it never sees a socket: HeaderGate accepts and holds connections, and the library
// is given a Stream over one of them. A connection serves one request: what a refusal leaves unread is never taken for
// the next. It limits neither chunked nor compressed bodies, so bytes are counted here, and of the header it gets
// the length of the body only (see header_block.h; Accept-Encoding would cost brotli's best compression,
// many Ranges a multiple of the answer). Its regular expressions are left out of routing.
#include "server/http.h"

#include <httplib.h>
#include <strings.h>
#include <sys/socket.h>

#include <algorithm>
#include <atomic>
#include <optional>
#include <string>

#include "server/header_block.h"
#include "server/header_gate.h"
#include "server/request_body.h"
#include "server/workers.h"

namespace coapt {
namespace {

using Handling = httplib::Server::HandlerResponse;

constexpr int kBacklog = 1024;           // the library's is 5: bursts would wait for a second
constexpr const char* kEveryPath = "/";  // what the library is told that each request's path is

// One request on its way. `answer` fills up with what the library writes, but for a stream.
struct Exchanged {
  Connection& connection;
  const HeaderBlock& header;
  Request request = {};
  const Route* route = nullptr;
  bool streams = false;
  std::string tail = {};  // the last four bytes of what has been read
  std::string answer = {};
  int status = 0;
};

// The library hands no context to its handlers; a thread serves one request at a time.
thread_local Exchanged* current = nullptr;

// What the library reads: the request line and how long the body is.
std::string library_header(const HeaderBlock& header) {
  std::string text = header.request_line + "\r\n";
  for (const char* name : {"content-length", "transfer-encoding"}) {
    if (header.fields.contains(name))
      text += std::string(name) + ": " + field(header, name) + "\r\n";
  }
  return text + "\r\n";
}

class ExchangeStream final : public httplib::Stream {
 public:
  ExchangeStream(Exchanged& exchanged, double answer_seconds)
      : exchanged_(exchanged),
        header_(library_header(exchanged.header)),
        answer_seconds_(answer_seconds) {}

  bool is_readable() const override { return true; }
  bool is_writable() const override { return !exchanged_.connection.client_gone(); }
  ssize_t read(char* to, std::size_t size) override {
    if (taken_ == header_.size()) {
      const std::size_t got = exchanged_.connection.read(to, size);
      exchanged_.tail.append(to + (got > 4 ? got - 4 : 0), std::min<std::size_t>(got, 4));
      if (exchanged_.tail.size() > 4) exchanged_.tail.erase(0, exchanged_.tail.size() - 4);
      return static_cast<ssize_t>(got);
    }
    const std::size_t count = header_.copy(to, size, taken_);
    taken_ += count;
    return static_cast<ssize_t>(count);
  }
  ssize_t write(const char* from, std::size_t size) override {
    if (!exchanged_.streams) {
      exchanged_.answer.append(from, size);
    } else if (!exchanged_.connection.send({from, size}, answer_seconds_)) {
      return -1;
    }
    return static_cast<ssize_t>(size);
  }
  void get_remote_ip_and_port(std::string&, int&) const override {}
  void get_local_ip_and_port(std::string&, int&) const override {}
  socket_t socket() const override { return 0; }  // it refuses numbers of FD_SETSIZE and more

 private:
  Exchanged& exchanged_;
  std::string header_;
  std::size_t taken_ = 0;
  double answer_seconds_;
};

std::string_view method_name(std::string_view method) {
  for (const std::string_view known :
       {"GET", "HEAD", "POST", "PUT", "PATCH", "DELETE", "OPTIONS"}) {
    if (known == method) return known;
  }
  return "other";
}

}  // namespace

struct HttpServer::Inside : httplib::Server {
  Inside(const HttpLimits& given, const Routes& their_routes, const Access& their_access,
         Observe their_observe);

  void set_up();
  Handling before_body(const httplib::Request& given, httplib::Response& response);
  void with_body(httplib::Response& response, const httplib::ContentReader& reader);
  std::optional<Answer> read_body(const httplib::ContentReader& reader);
  void respond(Answer answer, httplib::Response& response);
  void respond_stream(const coapt::Stream& stream, httplib::Response& response);
  void admit(Arrival arrival);
  std::string serve(Connection& connection, std::string_view header_bytes, Clock::time_point since);

  const HttpLimits limits;
  const Routes& routes;
  const Access& access;
  const Observe observe;
  Descriptor listening;
  std::atomic<int> streams = 0;
  HeaderGate gate;
  Workers workers;

  // The library asks it whether it is to end its streams.
  void end_streams() { svr_sock_ = INVALID_SOCKET; }
  int listening_socket() const { return svr_sock_; }
  using httplib::Server::process_request;
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
      workers(given.requests) {
  set_up();
}

void HttpServer::Inside::set_up() {
  // The default also shares the port with any other process that asks for it.
  set_socket_options([](socket_t socket) {
    const int yes = 1;
    setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof(yes));
  });
  set_exception_handler([this](const auto&, httplib::Response& response,
                               const std::exception_ptr&) {
    respond(problem(500, ErrorCode::Unsupported, "the request could not be answered"), response);
  });
  // What the library refuses by itself, such as a method it does not know, has no body.
  set_error_handler(httplib::Server::HandlerWithResponse([this](const auto&, auto& response) {
    if (!response.body.empty()) return Handling::Unhandled;
    respond(problem(response.status, ErrorCode::Unsupported, "this request cannot be taken"),
            response);
    return Handling::Handled;
  }));
  set_pre_routing_handler(
      [this](const auto& request, auto& response) { return before_body(request, response); });
  const auto handler = [this](const auto&, httplib::Response& response,
                              const httplib::ContentReader& reader) {
    with_body(response, reader);
  };
  Post(kEveryPath, handler);
  Put(kEveryPath, handler);
  Patch(kEveryPath, handler);
  set_post_routing_handler([](const httplib::Request&, httplib::Response& response) {
    current->status = response.status;
    if (response.status == 204) response.headers.erase("Content-Length");
  });
}

Handling HttpServer::Inside::before_body(const httplib::Request& given,
                                         httplib::Response& response) {
  Request& request = current->request;
  request.method = given.method == "HEAD" ? "GET" : given.method;
  request.query = {given.params.begin(), given.params.end()};
  request.headers = current->header.fields;
  const auto handled = [&](Answer answer) {
    respond(std::move(answer), response);
    return Handling::Handled;
  };
  if (std::optional<Answer> refusal = refuse(access, request)) return handled(*std::move(refusal));
  Found found = find_route(routes, request);
  if (found.route == nullptr) return handled(std::move(found.refusal));
  current->route = found.route;
  request.parameters = std::move(found.parameters);
  if (!brings_body(request.method + ' ')) return handled(found.route->endpoint(request));
  if (std::optional<Answer> refusal = refuse_body(current->header, limits.body_bytes)) {
    return handled(*std::move(refusal));
  }
  return Handling::Unhandled;
}

std::optional<Answer> HttpServer::Inside::read_body(const httplib::ContentReader& reader) {
  Connection& connection = current->connection;
  // Chunks may be small: a quarter more on the wire is taken for their headers.
  connection.start_reading({limits.body_seconds, limits.body_bytes_per_second, 2.0,
                            limits.body_bytes + limits.body_bytes / 4 + (64 << 10)});
  if (strcasecmp(field(current->header, "expect").c_str(), "100-continue") == 0 &&
      !connection.send("HTTP/1.1 100 Continue\r\n\r\n", limits.answer_seconds)) {
    return problem(400, ErrorCode::InvalidJson, "the client is gone");
  }
  std::string& body = current->request.body;
  const bool complete = reader([&](const char* bytes, std::size_t size) {
    body.append(bytes, size);
    return body.size() <= limits.body_bytes;
  });
  if (body.size() > limits.body_bytes || connection.read_end() == ReadEnd::TooMuch) {
    return too_large(limits.body_bytes);
  }
  // To the library a chunk without an end is the end of the body.
  const bool chunked = current->header.fields.contains("transfer-encoding");
  if (complete && (!chunked || current->tail == "\r\n\r\n")) return std::nullopt;
  switch (connection.read_end()) {
    case ReadEnd::TooSlow:
      return problem(408, ErrorCode::OutOfRange, "the body has not come in time");
    case ReadEnd::GivenUp:
      return problem(503, ErrorCode::Busy, "the server stops");
    case ReadEnd::ClientEnded:
    case ReadEnd::TooMuch:
      return problem(400, ErrorCode::InvalidJson, "the body ends too early");
    case ReadEnd::None:
      break;
  }
  return problem(400, ErrorCode::InvalidJson, "the body is not well chunked");
}

void HttpServer::Inside::with_body(httplib::Response& response,
                                   const httplib::ContentReader& reader) {
  std::optional<Answer> refusal = read_body(reader);
  respond(refusal ? *std::move(refusal) : current->route->endpoint(current->request), response);
}

void HttpServer::Inside::respond(Answer answer, httplib::Response& response) {
  response.headers.clear();
  if (const auto* stream = std::get_if<coapt::Stream>(&answer.body)) {
    if (streams.fetch_add(1) >= limits.streams) {
      --streams;
      return respond(problem(503, ErrorCode::Busy, "too many streams are open"), response);
    }
    respond_stream(*stream, response);
  } else if (const std::string bytes = content_bytes(answer); !bytes.empty()) {
    response.set_content(bytes, content_type(answer));
  }
  response.status = answer.status;
  for (const auto& [name, value] : all_headers(answer)) response.set_header(name, value);
  // Else the library says "bytes" to HEAD.
  response.set_header("Accept-Ranges", "none");
}

void HttpServer::Inside::respond_stream(const coapt::Stream& stream, httplib::Response& response) {
  current->streams = true;
  const std::shared_ptr<void> slot(nullptr, [this](void*) { --streams; });
  response.set_content_provider(
      stream.type, [slot, next = stream.next](std::size_t, httplib::DataSink& sink) {
        try {
          const auto send = [&](std::string_view part) {
            return sink.is_writable() && sink.write(part.data(), part.size());
          };
          if (!sink.is_writable() || !next(send)) sink.done();
          return true;
        } catch (...) {
          return false;
        }
      });
}

void HttpServer::Inside::admit(Arrival arrival) {
  const bool body = brings_body(arrival.bytes);
  // std::function wants what can be copied.
  const auto shared = std::make_shared<Arrival>(std::move(arrival));
  workers.add(body, [this, shared] {
    const std::string header = shared->bytes.substr(0, shared->header_bytes);
    Connection connection(std::move(shared->socket), shared->bytes.substr(shared->header_bytes),
                          gate.given_up());
    std::string answer;
    try {
      answer = serve(connection, header, shared->since);
    } catch (...) {
      // Out of memory, for instance: the client gets an end without an answer, the others are served.
    }
    gate.give_back(connection.release(), std::move(answer));
  });
}

// The answer, as far as it has not been sent.
std::string HttpServer::Inside::serve(Connection& connection, std::string_view header_bytes,
                                      Clock::time_point since) {
  const std::optional<HeaderBlock> header = parse_header(header_bytes);
  if (!header) {
    observe({"other", "none", 400, 0.0});
    return as_http(problem(400, ErrorCode::Unsupported, "the header cannot be read"));
  }
  Exchanged exchanged{connection, *header};
  current = &exchanged;
  ExchangeStream stream(exchanged, limits.answer_seconds);
  bool closed = false;
  std::string_view method = "other";
  process_request(stream, true, closed, [&](httplib::Request& request) {
    method = method_name(request.method);
    exchanged.request.path = std::exchange(request.path, kEveryPath);
  });
  current = nullptr;
  const std::chrono::duration<double> seconds = Clock::now() - since;
  observe({method, exchanged.route == nullptr ? "none" : exchanged.route->path, exchanged.status,
           seconds.count()});
  return std::move(exchanged.answer);
}

HttpServer::HttpServer(const HttpLimits& limits, const Routes& routes, const Access& access,
                       Observe observe)
    : inside_(std::make_unique<Inside>(limits, routes, access, std::move(observe))) {}

HttpServer::~HttpServer() = default;

Expected<int> HttpServer::bind(const std::string& host, int port) {
  const int bound = port == 0                           ? inside_->bind_to_any_port(host)
                    : inside_->bind_to_port(host, port) ? port
                                                        : -1;
  if (bound < 0) {
    return Error{ErrorCode::InputOutput, "",
                 host + ':' + std::to_string(port) + " cannot be listened on"};
  }
  inside_->listening = Descriptor(inside_->listening_socket());
  ::listen(inside_->listening.number(), kBacklog);
  return bound;
}

bool HttpServer::run() { return inside_->gate.run(std::move(inside_->listening)); }

void HttpServer::stop() {
  inside_->end_streams();
  inside_->gate.stop();
}

HttpLoad HttpServer::load() const {
  return {inside_->gate.connections(), inside_->workers.busy(), inside_->streams};
}

}  // namespace coapt
