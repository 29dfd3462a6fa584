#include "search/population/bootstrap.h"

#include <algorithm>
#include <limits>
#include <random>
#include <vector>

#include "search/random_share.h"

namespace coapt {
namespace {

constexpr int kResamples = 1000;
constexpr int kTail = 25;  // of them on either side: 2.5 %

}  // namespace

MeanInterval mean_interval(std::span<const double> values) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  if (values.empty()) return {nan, nan, nan, 0};
  const double n = static_cast<double>(values.size());
  std::mt19937_64 engine(1);
  std::vector<double> means(kResamples);
  for (double& mean : means) {
    for (std::size_t i = 0; i < values.size(); ++i)
      mean += values[static_cast<std::size_t>(random_share(engine) * n)];
    mean /= n;
  }
  std::sort(means.begin(), means.end());
  double sum = 0.0;
  for (const double value : values) sum += value;
  return {sum / n, means[kTail], means[kResamples - 1 - kTail], static_cast<int>(values.size())};
}

}  // namespace coapt
