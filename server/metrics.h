// What the service has done, in Prometheus' text format 0.0.4.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "server/http.h"

namespace coapt {

/// Of now: "coapt_jobs{state=\"queued\"}", 3.
using Gauges = std::vector<std::pair<std::string, double>>;

class Metrics {
 public:
  void observe(const Exchange& exchange);
  std::string text(const Gauges& gauges) const;

 private:
  static constexpr std::array kBounds_s = {0.001, 0.002, 0.005, 0.01, 0.02, 0.05,
                                           0.1,   0.2,   0.5,   1.0,  5.0,  30.0};
  struct Timing {
    std::array<std::int64_t, kBounds_s.size()> below{};
    std::int64_t count = 0;
    double sum_s = 0.0;
  };

  mutable std::mutex mutex_;
  std::map<std::pair<std::string, int>, std::int64_t> requests_;  // method and route; status
  std::map<std::string, Timing> timings_;                         // by method and route
};

/// Memory of this process now, bytes; 0 if the system does not say.
double resident_bytes();

}  // namespace coapt
