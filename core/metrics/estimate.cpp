#include "core/metrics/estimate.h"

#include <algorithm>
#include <cmath>

#include "core/metrics/quantile.h"

namespace coapt {

const char* to_string(ErrorCause cause) {
  switch (cause) {
    case ErrorCause::Numerical:
      return "numerical";
    case ErrorCause::Tissue:
      return "tissue";
    case ErrorCause::Execution:
      return "execution";
  }
  return "";
}

std::optional<ErrorCause> widest(const Estimate& estimate) {
  std::optional<ErrorCause> cause;
  double width = -1.0;
  const auto look_at = [&](const std::optional<Interval>& part, ErrorCause of) {
    if (!part || !(part->high - part->low > width)) return;
    width = part->high - part->low;
    cause = of;
  };
  look_at(estimate.numerical, ErrorCause::Numerical);
  look_at(estimate.tissue, ErrorCause::Tissue);
  look_at(estimate.execution, ErrorCause::Execution);
  return cause;
}

std::optional<Interval> area_interval(double area_mm2, double error_mm2) {
  if (!std::isfinite(area_mm2) || !std::isfinite(error_mm2)) return std::nullopt;
  return Interval{std::max(0.0, area_mm2 - error_mm2), area_mm2 + error_mm2};
}

std::optional<Interval> sampled_interval(const std::vector<double>& values,
                                         const std::vector<double>& weights) {
  constexpr std::ptrdiff_t kLeastSamples = 5;
  const std::ptrdiff_t count = weights.empty() ? std::ssize(values)
                                               : std::count_if(weights.begin(), weights.end(),
                                                               [](double w) { return w > 0.0; });
  if (count < kLeastSamples) return std::nullopt;
  return Interval{quantile(values, weights, 0.05), quantile(values, weights, 0.95)};
}

}  // namespace coapt
