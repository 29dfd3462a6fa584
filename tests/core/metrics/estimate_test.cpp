#include "core/metrics/estimate.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/metrics/quantile.h"

namespace coapt {
namespace {

TEST(Quantile, OfEqualWeightsIsThatWithoutWeights) {
  const std::vector<double> values = {7.0, 1.0, 4.0, 2.0, 9.0};
  for (const double share : {0.0, 0.05, 0.3, 0.5, 0.95, 1.0})
    EXPECT_NEAR(quantile(values, std::vector<double>(5, 0.2), share), quantile(values, share),
                1e-12);
  EXPECT_EQ(quantile(values, {}, 0.5), 4.0);
}

TEST(Quantile, OfAValueWithoutWeightIsAsIfItWereNotThere) {
  EXPECT_NEAR(quantile({1.0, 2.0, 3.0, 100.0}, {1.0, 1.0, 1.0, 0.0}, 0.95),
              quantile({1.0, 2.0, 3.0}, 0.95), 1e-12);
  EXPECT_EQ(quantile({1.0, 2.0, 3.0}, {0.0, 0.5, 0.0}, 0.05), 2.0);
}

TEST(Quantile, IsDrawnToTheHeavyValue) {
  // Middles of the weights at 0.5, 3, 5.5 of 0.5 to 5.5: half-way lies at the middle value.
  EXPECT_EQ(quantile({1.0, 2.0, 10.0}, {1.0, 4.0, 1.0}, 0.5), 2.0);
  EXPECT_EQ(quantile({1.0, 2.0, 10.0}, {1.0, 4.0, 1.0}, 0.25), 1.5);
}

TEST(Estimate, OfAnAreaReachesFromZero) {
  EXPECT_EQ(area_interval(0.5, 0.8), (Interval{0.0, 1.3}));
  EXPECT_EQ(area_interval(45.0, 2.5), (Interval{42.5, 47.5}));
  EXPECT_EQ(area_interval(45.0, std::nan("")), std::nullopt);
}

TEST(Estimate, OfFewSamplesIsNotKnown) {
  EXPECT_EQ(sampled_interval({1.0, 2.0, 3.0, 4.0}), std::nullopt);
  EXPECT_EQ(sampled_interval({1.0, 2.0, 3.0, 4.0, 5.0}, {1.0, 1.0, 1.0, 1.0, 0.0}), std::nullopt);
  const std::optional<Interval> of = sampled_interval({0.0, 1.0, 2.0, 3.0, 4.0});
  ASSERT_TRUE(of);
  EXPECT_NEAR(of->low, 0.2, 1e-12);
  EXPECT_NEAR(of->high, 3.8, 1e-12);
}

TEST(Estimate, ShowsItsWidestPart) {
  Estimate estimate{10.0};
  EXPECT_EQ(widest(estimate), std::nullopt);
  estimate.numerical = {8.0, 12.0};
  EXPECT_EQ(widest(estimate), ErrorCause::Numerical);
  estimate.tissue = {2.0, 30.0};
  estimate.execution = {9.0, 20.0};
  EXPECT_EQ(widest(estimate), ErrorCause::Tissue);
  EXPECT_STREQ(to_string(ErrorCause::Execution), "execution");
}

}  // namespace
}  // namespace coapt
