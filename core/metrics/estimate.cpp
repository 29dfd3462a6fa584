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

const std::optional<Interval>& part_of(const Estimate& estimate, ErrorCause cause) {
  switch (cause) {
    case ErrorCause::Numerical:
      return estimate.numerical;
    case ErrorCause::Tissue:
      return estimate.tissue;
    case ErrorCause::Execution:
      break;
  }
  return estimate.execution;
}

bool tissue_excludes_value(const Estimate& estimate) {
  if (!estimate.tissue) return false;
  const Interval computed = estimate.numerical.value_or(Interval{estimate.value, estimate.value});
  return computed.high < estimate.tissue->low || computed.low > estimate.tissue->high;
}

std::optional<ErrorCause> widest(const Estimate& estimate) {
  if (tissue_excludes_value(estimate)) return ErrorCause::Tissue;
  std::optional<ErrorCause> cause;
  double width = -1.0;
  for (const ErrorCause of : {ErrorCause::Numerical, ErrorCause::Tissue, ErrorCause::Execution}) {
    const std::optional<Interval>& part = part_of(estimate, of);
    if (!part || !(part->high - part->low > width)) continue;
    width = part->high - part->low;
    cause = of;
  }
  return cause;
}

Estimate scaled(Estimate estimate, double units) {
  estimate.value *= units;
  for (std::optional<Interval>* part : {&estimate.numerical, &estimate.tissue, &estimate.execution})
    if (*part) *part = Interval{units * (*part)->low, units * (*part)->high};
  return estimate;
}

double half_width(const Estimate& estimate) {
  const std::optional<ErrorCause> cause = widest(estimate);
  if (!cause) return std::numeric_limits<double>::quiet_NaN();
  const Interval wide = *part_of(estimate, *cause);
  return 0.5 * (wide.high - wide.low);
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
  return Interval{predicted_quantile(values, weights, 0.05),
                  predicted_quantile(values, weights, 0.95)};
}

}  // namespace coapt
