#pragma once

#include <algorithm>
#include <cmath>
#include <utility>
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

/// The same of values that count by their weights, >= 0 and not all 0 (empty: all alike): between the values the middles of their
/// weights are interpolated, so that equal weights give the quantile above.
inline double quantile(const std::vector<double>& values, const std::vector<double>& weights,
                       double share) {
  if (weights.empty()) return quantile(values, share);
  std::vector<std::pair<double, double>> sorted;
  for (std::size_t i = 0; i < values.size(); ++i)
    if (weights[i] > 0.0) sorted.emplace_back(values[i], weights[i]);
  std::sort(sorted.begin(), sorted.end());
  double sum = 0.0;
  for (const auto& [value, weight] : sorted) sum += weight;
  const double first = 0.5 * sorted.front().second, last = 0.5 * sorted.back().second;
  const double wanted = first + share * (sum - first - last);
  double middle = first;
  for (std::size_t i = 0; i + 1 < sorted.size(); ++i) {
    const double next = middle + 0.5 * (sorted[i].second + sorted[i + 1].second);
    if (wanted <= next)
      return std::lerp(sorted[i].first, sorted[i + 1].first, (wanted - middle) / (next - middle));
    middle = next;
  }
  return sorted.back().first;
}

}  // namespace coapt
