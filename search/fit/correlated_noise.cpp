#include "search/fit/correlated_noise.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace coapt {

CorrelatedNoise correlated_noise(const Points& points_mm, const std::vector<double>& residuals_mm) {
  constexpr std::size_t kBins = 30;
  constexpr double kBin_mm = 1.0;
  const auto n = static_cast<Eigen::Index>(residuals_mm.size());
  std::array<double, kBins> products{}, pairs{};
  double squares = 0.0;
  for (Eigen::Index i = 0; i < n; ++i) {
    const double own = residuals_mm[static_cast<std::size_t>(i)];
    squares += own * own;
    for (Eigen::Index j = i + 1; j < n; ++j) {
      const double distance = (points_mm.row(i) - points_mm.row(j)).norm();
      if (distance >= kBins * kBin_mm) continue;
      const auto bin = static_cast<std::size_t>(distance / kBin_mm);
      products[bin] += own * residuals_mm[static_cast<std::size_t>(j)];
      pairs[bin] += 1.0;
    }
  }
  const double count = static_cast<double>(n), variance = squares / count;
  if (variance == 0.0) return {0.0, count};
  double correlations = count;
  for (std::size_t bin = 0; bin < kBins; ++bin) {
    if (pairs[bin] == 0.0) continue;
    const double correlation = products[bin] / (pairs[bin] * variance);
    if (correlation <= 0.0) break;
    correlations += 2.0 * pairs[bin] * std::min(1.0, correlation);
  }
  return {std::sqrt(variance), count * count / correlations};
}

}  // namespace coapt
