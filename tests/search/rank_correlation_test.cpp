#include "search/rank_correlation.h"

#include <gtest/gtest.h>

#include <cmath>

namespace coapt {
namespace {

TEST(RankCorrelation, IsOneForAnyRisingAndMinusOneForAnyFallingRelation) {
  const std::vector<double> x = {3.0, 1.0, 4.0, 1.5, 9.0};
  std::vector<double> rising, falling;
  for (const double value : x) {
    rising.push_back(std::exp(value));
    falling.push_back(-value * value * value);
  }
  EXPECT_DOUBLE_EQ(rank_correlation(x, rising), 1.0);
  EXPECT_DOUBLE_EQ(rank_correlation(x, falling), -1.0);
}

TEST(RankCorrelation, OfFivePairsIsAsByHand) {
  // Ranks 1 2 3 4 5 and 2 1 4 3 5: 1 - 6 (1 + 1 + 1 + 1) / (5 x 24).
  EXPECT_NEAR(rank_correlation({10, 20, 30, 40, 50}, {2.0, 1.0, 4.0, 3.0, 5.0}), 0.8, 1e-12);
}

TEST(RankCorrelation, EqualValuesShareTheirMeanRank) {
  // Ranks 1.5 1.5 3 and 1 2 3: covariance 1.5 of variances 1.5 and 2.
  EXPECT_NEAR(rank_correlation({7.0, 7.0, 8.0}, {1.0, 2.0, 3.0}), 1.5 / std::sqrt(3.0), 1e-12);
  EXPECT_NEAR(rank_correlation({7.0, 7.0, 8.0}, {2.0, 1.0, 3.0}), 1.5 / std::sqrt(3.0), 1e-12);
}

TEST(RankCorrelation, SaysNothingOfAConstantOrOfLessThanTwo) {
  EXPECT_TRUE(std::isnan(rank_correlation({1.0, 1.0, 1.0}, {1.0, 2.0, 3.0})));
  EXPECT_TRUE(std::isnan(rank_correlation({1.0, 2.0, 3.0}, {4.0, 4.0, 4.0})));
  EXPECT_TRUE(std::isnan(rank_correlation({1.0}, {2.0})));
  EXPECT_TRUE(std::isnan(rank_correlation({}, {})));
}

}  // namespace
}  // namespace coapt
