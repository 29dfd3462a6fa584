// HTTP: the only header behind which cpp-httplib stands.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "server/access.h"
#include "server/route.h"

namespace coapt {

struct HttpLimits {
  std::size_t header_bytes = 16 << 10;            ///< request line and headers
  std::size_t body_bytes = std::size_t{8} << 20;  ///< counted as they arrive, chunked or not
  double header_seconds = 10.0;                   ///< from the connection to the end of the headers
  double body_seconds = 60.0;  ///< from the first thread that is free to the end of the body
  double body_bytes_per_second = 16 << 10;  ///< at least, after two seconds
  double answer_seconds = 60.0;  ///< for the client to take the answer; for each part of a stream
  int connections =
      1024;  ///< at once; those over it push out the one that waits longest for its headers
  int requests =
      128;  ///< answered at once, streams among them, the others wait; with a body, half as many
  int streams = 32;  ///< open at once, over it 503
};

/// A request that was answered, for metrics and the log: nothing that a client wrote.
struct Exchange {
  std::string_view method;  ///< "GET", ..., "other"
  std::string_view route;   ///< pattern, or "none"
  int status = 0;
  double seconds =
      0.0;  ///< from the end of the headers until the answer is ready, a stream has ended
};

struct HttpLoad {
  int connections = 0, requests = 0, streams = 0;
};

/// One request a connection: what a refusal leaves unread can never be taken for the next request.
class HttpServer {
 public:
  using Observe = std::function<void(const Exchange&)>;  ///< from many threads at once

  /// `routes` and `access` must outlive it.
  HttpServer(const HttpLimits& limits, const Routes& routes, const Access& access, Observe observe);
  ~HttpServer();

  /// Port 0 takes a free one. The port, or an error. @param host an address, or a name for one
  Expected<int> bind(const std::string& host, int port);
  /// Serves until stop(), once; returns when all requests have been answered, and 2 s after it gives up
  /// what only waits for a client. False if it could not accept connections.
  bool run();
  /// No more connections; streams end. From any thread, also before run().
  void stop();

  HttpLoad load() const;

 private:
  struct Inside;
  std::unique_ptr<Inside> inside_;
};

}  // namespace coapt
