#include "server/metrics.h"

#include <unistd.h>

#include <fstream>
#include <sstream>

#include "core/valve/problem_list.h"

namespace coapt {
namespace {

std::string labels(const Exchange& exchange) {
  return "method=\"" + std::string(exchange.method) + "\",route=\"" + std::string(exchange.route) +
         '"';
}

void describe(std::ostream& out, const std::string& name, const char* type, const char* help) {
  out << "# HELP " << name << ' ' << help << "\n# TYPE " << name << ' ' << type << '\n';
}

}  // namespace

void Metrics::observe(const Exchange& exchange) {
  const std::string who = labels(exchange);
  const std::lock_guard<std::mutex> lock(mutex_);
  ++requests_[{who, exchange.status}];
  Timing& timing = timings_[who];
  ++timing.count;
  timing.sum_s += exchange.seconds;
  for (std::size_t i = 0; i < kBounds_s.size(); ++i)
    if (exchange.seconds <= kBounds_s[i]) ++timing.below[i];
}

std::string Metrics::text(const Gauges& gauges) const {
  std::ostringstream out;
  out.precision(17);
  describe(out, "coapt_http_requests_total", "counter", "Requests answered.");
  const std::lock_guard<std::mutex> lock(mutex_);
  for (const auto& [key, count] : requests_)
    out << "coapt_http_requests_total{" << key.first << ",status=\"" << key.second << "\"} "
        << count << '\n';
  describe(out, "coapt_http_request_seconds", "histogram",
           "Time from the end of a request's headers until its answer is ready; 0 if it had none "
           "to read.");
  for (const auto& [who, timing] : timings_) {
    for (std::size_t i = 0; i < kBounds_s.size(); ++i)
      out << "coapt_http_request_seconds_bucket{" << who << ",le=\"" << shown(kBounds_s[i])
          << "\"} " << timing.below[i] << '\n';
    out << "coapt_http_request_seconds_bucket{" << who << ",le=\"+Inf\"} " << timing.count << '\n'
        << "coapt_http_request_seconds_sum{" << who << "} " << timing.sum_s << '\n'
        << "coapt_http_request_seconds_count{" << who << "} " << timing.count << '\n';
  }
  std::string family;
  for (const auto& [name, value] : gauges) {
    const std::string of = name.substr(0, name.find('{'));
    if (of != family) describe(out, family = of, "gauge", "Now.");
    out << name << ' ' << value << '\n';
  }
  return out.str();
}

double resident_bytes() {
  std::ifstream statm("/proc/self/statm");
  double total = 0.0, resident = 0.0;
  statm >> total >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE));
}

}  // namespace coapt
