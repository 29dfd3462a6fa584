#include "demo_server.h"

#include <stdexcept>

#include "client.h"

namespace coapt {
namespace {

void pause() { std::this_thread::sleep_for(std::chrono::milliseconds(5)); }

}  // namespace

bool eventually(const std::function<bool()>& holds) {
  const Clock::time_point deadline = after(kHangSeconds);
  while (!holds()) {
    if (Clock::now() > deadline) return false;
    pause();
  }
  return true;
}

Routes DemoServer::routes() {
  return {
      {"GET", "/healthz/live",
       [](const Request&) {
         return json_answer(200, {{"status", "live"}});
       }},
      {"GET", "/demo/{name}",
       [](const Request& request) {
         return json_answer(200, {{"name", request.parameters.at(0)}, {"query", request.query}});
       }},
      {"POST", "/demo/{name}",
       [](const Request& request) {
         return json_answer(200, {{"bytes", request.body.size()},
                                  {"key", request.headers.contains("idempotency-key")}});
       }},
      {"DELETE", "/demo/{name}", [](const Request&) { return Answer{204}; }},
      {"GET", "/header", [](const Request& request) { return json_answer(200, request.headers); }},
      {"GET", "/page",
       [](const Request&) {
         return Answer{
             200, Content{"text/html; charset=utf-8", "<p>"}, {{"Cache-Control", "max-age=60"}}};
       }},
      {"GET", "/large",
       [](const Request&) {
         return Answer{200, Content{"text/plain", std::string(32 << 20, 'x')}};
       }},
      {"GET", "/wait",
       [this](const Request&) {
         eventually([this] { return latch_.load(); });
         return json_answer(200, {{"waited", true}});
       }},
      {"GET", "/throws", [](const Request&) -> Answer { throw std::runtime_error("secret"); }},
      {"GET", "/ticks",
       [](const Request&) {
         return Answer{200, Stream{"text/event-stream", [](const Send& send) {
                                     pause();
                                     return send("data: tick\n\n");
                                   }}};
       }},
      {"GET", "/quiet",
       [](const Request&) {
         return Answer{200, Stream{"text/event-stream", [](const Send&) {
                                     pause();
                                     return true;
                                   }}};
       }},
      {"GET", "/flood",
       [](const Request&) {
         return Answer{200, Stream{"text/event-stream", [](const Send& send) {
                                     return send(std::string(1 << 16, 'x'));
                                   }}};
       }},
      {"GET", "/three",
       [](const Request&) {
         return Answer{200, Stream{"text/event-stream", [count = 0](const Send& send) mutable {
                                     return send("data: one of three\n\n") && ++count < 3;
                                   }}};
       }},
  };
}

DemoServer::DemoServer(const HttpLimits& limits, Access access)
    : access_(std::move(access)),
      routes_(routes()),
      server_(limits, routes_, access_, [this](const Exchange& exchange) {
        const std::lock_guard lock(mutex_);
        ++exchanges_[std::string(exchange.method) + ' ' + std::string(exchange.route) + ' ' +
                     std::to_string(exchange.status)];
      }) {
  const Expected<int> bound = server_.bind("127.0.0.1", 0);
  if (!bound) throw std::runtime_error(bound.errors().front().message);
  port_ = *bound;
  thread_ = std::thread([this] {
    server_.run();
    ended_ = true;
  });
}

DemoServer::~DemoServer() {
  open_latch();
  server_.stop();
  thread_.join();
}

std::map<std::string, int> DemoServer::exchanges() const {
  const std::lock_guard lock(mutex_);
  return exchanges_;
}

void DemoServer::stop() { server_.stop(); }

bool DemoServer::ended(double seconds) const {
  const Clock::time_point deadline = after(seconds);
  while (!ended_ && Clock::now() < deadline) pause();
  return ended_;
}

}  // namespace coapt
