#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

namespace coapt {

/// Linear interpolation between order statistics; `share` in [0, 1]; 0 for an empty list.
inline double quantile(std::vector<double> values, double share) {
  if (values.empty()) return 0.0;
  std::sort(values.begin(), values.end());
  const double position = share * static_cast<double>(values.size() - 1);
  const std::size_t below = static_cast<std::size_t>(position);
  const std::size_t above = std::min(below + 1, values.size() - 1);
  return std::lerp(values[below], values[above], position - static_cast<double>(below));
}

}  // namespace coapt
