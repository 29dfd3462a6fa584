// The HTTP server: from connections to routes and back.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "server/access.h"
#include "server/http_limits.h"
#include "server/route.h"

namespace coapt {

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
