#include "search/population/truncated_normal.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "search/training/binomial.h"

namespace coapt {
namespace {

double normal_cdf(double z) { return 0.5 * std::erfc(-z / std::numbers::sqrt2); }
double normal_density(double z) {
  return std::exp(-0.5 * z * z) / std::sqrt(2.0 * std::numbers::pi);
}

struct CutShares {
  double low = 0.0, high = 1.0;  // of the whole normal distribution, at the ends
};

CutShares cut_shares(const PriorDistribution& d) {
  return {normal_cdf((d.min - d.mean) / d.sd), normal_cdf((d.max - d.mean) / d.sd)};
}

}  // namespace

double truncated_normal(const PriorDistribution& d, double standard) {
  if (d.sd <= 0.0) return d.mean;
  const CutShares cut = cut_shares(d);
  const double share = cut.low + normal_cdf(standard) * (cut.high - cut.low);
  if (share <= 0.0) return d.min;
  if (share >= 1.0) return d.max;
  return std::clamp(d.mean + d.sd * normal_quantile(share), d.min, d.max);
}

double share_below(const PriorDistribution& d, double value) {
  if (d.sd <= 0.0) return 0.5;
  const CutShares cut = cut_shares(d);
  return std::clamp((normal_cdf((value - d.mean) / d.sd) - cut.low) / (cut.high - cut.low), 0.0,
                    1.0);
}

MeanAndSd cut_moments(const PriorDistribution& d) {
  if (d.sd <= 0.0) return {d.mean, 0.0};
  const double low = (d.min - d.mean) / d.sd, high = (d.max - d.mean) / d.sd;
  const CutShares cut = cut_shares(d);
  const double kept = cut.high - cut.low,
               shift = (normal_density(low) - normal_density(high)) / kept;
  const double spread =
      1.0 + (low * normal_density(low) - high * normal_density(high)) / kept - shift * shift;
  return {d.mean + d.sd * shift, d.sd * std::sqrt(spread)};
}

}  // namespace coapt
