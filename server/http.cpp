// cpp-httplib 0.11.4 needs some care. It limits neither chunked nor compressed bodies, so bytes are
// counted here as they arrive. It answers a refusal before the body is read and would take that
// body for the next request, so a connection serves one request only, and what is refused is first
// read to a second limit: closing on unread bytes can lose the answer. Its regular expressions are
// left out of routing.
#include "server/http.h"

#include <httplib.h>
#include <pthread.h>
#include <sys/socket.h>

#include <csignal>
#include <iostream>
#include <optional>
#include <string>
#include <thread>

namespace coapt {
namespace {

constexpr const char* kHost = "127.0.0.1";
constexpr const char* kAnyPath = R"([\s\S]*)";
constexpr std::size_t kMaxDiscardedBytes = 4 * kMaxBodyBytes;

void send(const Answer& answer, httplib::Response& response) {
  response.status = answer.status;
  response.set_content(answer.body.dump(),
                       answer.status < 400 ? "application/json" : "application/problem+json");
}

Answer refusal(int status, ErrorCode code, const std::string& message) {
  return problem(status, {Error{code, "", message}});
}

/// Finds the route of a request; if there is none, `response` is answered.
const Route* find_route(const Routes& routes, const httplib::Request& request,
                        httplib::Response& response) {
  const std::string method = request.method == "HEAD" ? "GET" : request.method;
  std::string allowed;
  for (const Route& route : routes) {
    if (route.path != request.path) continue;
    if (route.method == method) return &route;
    allowed += (allowed.empty() ? "" : ", ") + std::string(route.method);
  }
  if (allowed.empty()) {
    send(refusal(404, ErrorCode::BadReference, "no such path"), response);
  } else {
    response.set_header("Allow", allowed);
    send(refusal(405, ErrorCode::Unsupported, "this path takes " + allowed), response);
  }
  return nullptr;
}

/// Reads at most kMaxBodyBytes into `body` and drops the rest. Returns a refusal if that is not
/// all.
std::optional<Answer> read_body(const httplib::ContentReader& reader, std::string& body) {
  std::size_t received = 0;
  const bool complete = reader([&](const char* bytes, std::size_t size) {
    received += size;
    if (received <= kMaxBodyBytes) body.append(bytes, size);
    return received <= kMaxDiscardedBytes;
  });
  if (received > kMaxBodyBytes) {
    return refusal(413, ErrorCode::OutOfRange, "the body is larger than 64 MiB");
  }
  if (!complete) return refusal(400, ErrorCode::InvalidJson, "the body ends too early");
  return std::nullopt;
}

void answer_with_body(const Routes& routes, const httplib::Request& request,
                      httplib::Response& response, const httplib::ContentReader& reader) {
  if (request.is_multipart_form_data()) {
    return send(refusal(415, ErrorCode::Unsupported, "the body must be application/json"),
                response);
  }
  if (!request.has_header("Content-Length") && !request.has_header("Transfer-Encoding")) {
    return send(refusal(411, ErrorCode::MissingField, "the body has no Content-Length"), response);
  }
  std::string body;
  const std::optional<Answer> refused = read_body(reader, body);
  if (request.has_header("Content-Encoding")) {
    return send(refusal(415, ErrorCode::Unsupported, "the body must not be encoded"), response);
  }
  const Route* route = find_route(routes, request, response);
  if (route != nullptr) send(refused ? *refused : route->endpoint(body), response);
}

void answer_without_body(const Routes& routes, const httplib::Request& request,
                         httplib::Response& response) {
  if (const Route* route = find_route(routes, request, response)) {
    send(route->endpoint(""), response);
  }
}

void set_up(httplib::Server& http, const Routes& routes) {
  http.set_keep_alive_max_count(1);
  // The default also shares the port with any other process that asks for it.
  http.set_socket_options([](socket_t socket) {
    const int yes = 1;
    setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof(yes));
  });
  http.set_exception_handler(
      [](const auto&, httplib::Response& response, const std::exception_ptr&) {
        send(refusal(500, ErrorCode::Unsupported, "the request could not be answered"), response);
      });
  // What cpp-httplib refuses by itself, such as a method it does not know, has no body.
  using Handling = httplib::Server::HandlerResponse;
  http.set_error_handler(httplib::Server::HandlerWithResponse([](const auto&, auto& response) {
    if (!response.body.empty()) return Handling::Unhandled;
    send(refusal(response.status, ErrorCode::Unsupported, "this request cannot be taken"),
         response);
    return Handling::Handled;
  }));
  http.set_pre_routing_handler([&routes](const auto& request, httplib::Response& response) {
    if (request.method == "POST") return Handling::Unhandled;
    answer_without_body(routes, request, response);
    return Handling::Handled;
  });
  http.Post(kAnyPath, [&routes](const httplib::Request& request, httplib::Response& response,
                                const httplib::ContentReader& reader) {
    answer_with_body(routes, request, response, reader);
  });
}

sigset_t stop_signals() {
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGINT);
  sigaddset(&signals, SIGTERM);
  return signals;
}

}  // namespace

bool serve(int port, const Routes& routes, std::atomic<bool>& stopping) {
  httplib::Server http;
  set_up(http, routes);
  const int bound =
      port == 0 ? http.bind_to_any_port(kHost) : (http.bind_to_port(kHost, port) ? port : -1);
  if (bound < 0) return false;

  const sigset_t signals = stop_signals();
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  std::thread stopper([&] {
    int signal = 0;
    sigwait(&signals, &signal);
    stopping = true;
    http.stop();
  });
  std::cerr << "coapt-server: listening on http://" << kHost << ':' << bound << '\n';
  const bool served = http.listen_after_bind();
  pthread_kill(stopper.native_handle(), SIGINT);
  stopper.join();
  return served;
}

}  // namespace coapt
