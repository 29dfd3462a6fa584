#include "search/training/binomial.h"

#include <algorithm>
#include <cmath>

namespace coapt {

double chance_of_at_least(int right, int answers, double chance) {
  double sum = 0.0;
  for (int k = right; k <= answers; ++k)
    sum += std::exp(std::lgamma(answers + 1.0) - std::lgamma(k + 1.0) -
                    std::lgamma(answers - k + 1.0) + k * std::log(chance) +
                    (answers - k) * std::log1p(-chance));
  return std::min(1.0, sum);
}

std::array<double, 2> share_interval(int right, int answers) {
  const double z = normal_quantile(0.975), n = answers, share = right / n;
  const double centre = (share + z * z / (2.0 * n)) / (1.0 + z * z / n);
  const double half =
      z / (1.0 + z * z / n) * std::sqrt(share * (1.0 - share) / n + z * z / (4.0 * n * n));
  return {std::max(0.0, centre - half), std::min(1.0, centre + half)};
}

int answers_to_tell(double share, double other, double power) {
  const double mean = 0.5 * (share + other), difference = share - other;
  const double sum =
      normal_quantile(0.975) * std::sqrt(2.0 * mean * (1.0 - mean)) +
      normal_quantile(power) * std::sqrt(share * (1.0 - share) + other * (1.0 - other));
  return static_cast<int>(std::ceil(sum * sum / (difference * difference)));
}

double normal_quantile(double share) {
  double low = -40.0, high = 40.0;
  while (high - low > 1e-10) {
    const double middle = 0.5 * (low + high);
    (0.5 * std::erfc(-middle / std::sqrt(2.0)) < share ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace coapt
