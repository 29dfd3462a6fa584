// Written for cpp-httplib 0.11.4, libcpp-httplib-dev of Debian 12. Three things stand on its protected members and
// change upstream: process_request takes the addresses and ports of both ends as well (0.16); Stream has pure virtual
// wait_readable, wait_writable and duration in place of is_writable (0.19); svr_sock_ tells streams that the server
// stops. Each request has a library server of its own, so that its handlers know which request they serve.
#include "server/httplib_adapter.h"

#include <httplib.h>

#include <utility>

#include "server/header_block.h"

namespace coapt {
namespace {

using Handling = httplib::Server::HandlerResponse;

constexpr const char* kEveryPath =
    "/";  // what the library routes: its regular expressions are left out of it

class WireStream final : public httplib::Stream {
 public:
  WireStream(const Wire& wire, const bool& streams, std::string& unsent)
      : wire_(wire), streams_(streams), unsent_(unsent) {}

  bool is_readable() const override { return true; }
  bool is_writable() const override { return wire_.wants_more(); }
  ssize_t read(char* to, std::size_t size) override {
    if (taken_ == wire_.header.size()) return static_cast<ssize_t>(wire_.read(to, size));
    const std::size_t count = wire_.header.copy(to, size, taken_);
    taken_ += count;
    return static_cast<ssize_t>(count);
  }
  ssize_t write(const char* from, std::size_t size) override {
    if (streams_) return wire_.send({from, size}) ? static_cast<ssize_t>(size) : -1;
    unsent_.append(from, size);
    return static_cast<ssize_t>(size);
  }
  void get_remote_ip_and_port(std::string&, int&) const override {}
  void get_local_ip_and_port(std::string&, int&) const override {}
  socket_t socket() const override { return 0; }  // it refuses numbers of FD_SETSIZE and more

 private:
  const Wire& wire_;
  const bool& streams_;
  std::string& unsent_;
  std::size_t taken_ = 0;  // of the header
};

class OneRequest : httplib::Server {
 public:
  explicit OneRequest(const Serve& serve) : serve_(serve) {
    set_handlers();
    svr_sock_ = 0;  // else its streams would end at once
  }

  Served run(const Wire& wire) {
    WireStream stream(wire, streams_, served_.unsent);
    bool closed = false;
    process_request(stream, true, closed, [this](httplib::Request& request) {
      path_ = std::exchange(request.path, kEveryPath);
    });
    return std::move(served_);
  }

 private:
  void set_handlers() {
    set_pre_routing_handler([this](const httplib::Request& request, httplib::Response& response) {
      if (brings_body(request.method + ' ')) return Handling::Unhandled;
      respond(answer_to(request, {}), response);
      return Handling::Handled;
    });
    const auto with_body = [this](const httplib::Request& request, httplib::Response& response,
                                  const httplib::ContentReader& reader) {
      const auto read = [&reader](const std::function<bool(std::string_view)>& take) {
        return reader([&](const char* bytes, std::size_t size) { return take({bytes, size}); });
      };
      respond(answer_to(request, read), response);
    };
    Post(kEveryPath, with_body);
    Put(kEveryPath, with_body);
    Patch(kEveryPath, with_body);
    set_exception_handler([this](const auto&, httplib::Response& response,
                                 const std::exception_ptr&) {
      respond(problem(500, ErrorCode::Unsupported, "the request could not be answered"), response);
    });
    // What the library refuses by itself, such as a method it does not know, has no body.
    set_error_handler(httplib::Server::HandlerWithResponse([this](const auto&, auto& response) {
      if (!response.body.empty()) return Handling::Unhandled;
      respond(problem(response.status, ErrorCode::Unsupported, "this request is not accepted"),
              response);
      return Handling::Handled;
    }));
    set_post_routing_handler([this](const auto&, httplib::Response& response) {
      served_.status = response.status;
      if (response.status == 204 || response.status == 304)
        response.headers.erase("Content-Length");
    });
  }

  Answer answer_to(const httplib::Request& given, const ReadBody& read) {
    Request request;
    request.method = given.method;
    request.path = std::move(path_);
    request.query = {given.params.begin(), given.params.end()};
    return serve_(std::move(request), read);
  }

  void respond(const Answer& answer, httplib::Response& response) {
    response.headers.clear();
    if (const auto* stream = std::get_if<coapt::Stream>(&answer.body)) {
      streams_ = true;
      set_stream(*stream, response);
    } else if (const std::string bytes = content_bytes(answer); !bytes.empty()) {
      response.set_content(bytes, content_type(answer));
    }
    response.status = answer.status;
    for (const auto& [name, value] : all_headers(answer)) response.set_header(name, value);
    response.set_header("Accept-Ranges", "none");  // else the library says "bytes" to HEAD
  }

  static void set_stream(const coapt::Stream& stream, httplib::Response& response) {
    response.set_content_provider(
        stream.type, [next = stream.next](std::size_t, httplib::DataSink& sink) {
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

  const Serve& serve_;
  std::string path_;
  bool streams_ = false;
  Served served_;
};

}  // namespace

Served serve_request(const Wire& wire, const Serve& serve) { return OneRequest(serve).run(wire); }

}  // namespace coapt
