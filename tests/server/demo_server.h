// A server with a few routes of every kind, on a free port.
#pragma once

#include <atomic>
#include <map>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "server/http.h"

namespace coapt {

class DemoServer {
 public:
  explicit DemoServer(const HttpLimits& limits = {}, Access access = {});
  ~DemoServer();

  int port() const { return port_; }
  HttpLoad load() const { return server_.load(); }
  /// "GET /demo/{name} 200": how often.
  std::map<std::string, int> exchanges() const;
  void stop();                          ///< asks it to
  bool ended(double seconds) const;     ///< whether run() returns in time
  void open_latch() { latch_ = true; }  ///< lets those at /wait go on

 private:
  Routes routes();

  Access access_;
  std::atomic<bool> latch_ = false, ended_ = false;
  mutable std::mutex mutex_;
  std::map<std::string, int> exchanges_;
  const Routes routes_;
  HttpServer server_;
  int port_ = 0;
  std::thread thread_;
};

/// Waits until `holds`; false if it does not in time.
bool eventually(const std::function<bool()>& holds);

}  // namespace coapt
