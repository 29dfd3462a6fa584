#pragma once

#include <algorithm>
#include <cmath>
#include <numeric>
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

/// The greatest of the lightest weights, which together are a thousandth of all; equal weights are among them together or not at all. 0: none.
inline double lightest_weight(std::vector<double> weights) {
  std::sort(weights.begin(), weights.end());
  const double most = 1e-3 * std::accumulate(weights.begin(), weights.end(), 0.0);
  double sum = 0.0, light = 0.0;
  for (std::size_t i = 0; i + 1 < weights.size() && (sum += weights[i]) <= most; ++i)
    if (weights[i] < weights[i + 1]) light = weights[i];
  return light;
}

/// What one more value of the same kind stays below with probability `share`, as far as so few reach: the i-th of n says i / (n + 1) (Weibull
/// 1939), where the quantile above says (i - 1) / (n - 1) and makes intervals of few values too narrow. Between the middles of their weights
/// values are interpolated; n is the number that would say as much if all weighed alike (Kish 1965). The lightest values, a thousandth of
/// the weight together, are left out: where few values weigh, what lies at the ends is chance.
/// @param weights >= 0, not all 0; empty: all alike
inline double predicted_quantile(const std::vector<double>& values,
                                 const std::vector<double>& weights, double share) {
  const double light = lightest_weight(weights);
  std::vector<std::pair<double, double>> sorted;
  double sum = 0.0, squares = 0.0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double weight = weights.empty() ? 1.0 : weights[i];
    if (weight <= light) continue;
    sorted.emplace_back(values[i], weight);
    sum += weight;
    squares += weight * weight;
  }
  std::sort(sorted.begin(), sorted.end());
  const double wanted = share * sum + (share - 0.5) * squares / sum;
  double middle = 0.5 * sorted.front().second;
  if (wanted <= middle) return sorted.front().first;
  for (std::size_t i = 0; i + 1 < sorted.size(); ++i) {
    const double next = middle + 0.5 * (sorted[i].second + sorted[i + 1].second);
    if (wanted <= next)
      return std::lerp(sorted[i].first, sorted[i + 1].first, (wanted - middle) / (next - middle));
    middle = next;
  }
  return sorted.back().first;
}

}  // namespace coapt
