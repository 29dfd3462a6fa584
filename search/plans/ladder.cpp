#include "search/plans/ladder.h"

#include "search/rank_correlation.h"

namespace coapt {
namespace {

constexpr double kLeastCorrelation = 0.8;

}  // namespace

LadderStep measure_ladder_step(int from, int to, const std::vector<double>& few,
                               const std::vector<double>& many) {
  const double correlation = rank_correlation(few, many);
  return {from, to, static_cast<int>(few.size()), correlation, correlation < kLeastCorrelation};
}

}  // namespace coapt
