#include "core/metrics/estimate.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/metrics/estimate_text.h"
#include "core/metrics/quantile.h"

namespace coapt {
namespace {

TEST(Quantile, PredictedItHoldsOneMoreValueAsOftenAsItSays) {
  // The i-th of n values drawn evenly from 0 to 1 lies at i / (n + 1) in the mean.
  for (const int count : {19, 24, 63}) {
    std::vector<double> values;
    for (int i = 1; i <= count; ++i) values.push_back(i / (count + 1.0));
    for (const double share : {0.05, 0.5, 0.95})
      for (const std::vector<double>& weights :
           {std::vector<double>{}, std::vector(values.size(), 0.3)})
        EXPECT_NEAR(predicted_quantile(values, weights, share), share, 1e-12) << count;
  }
}

TEST(Quantile, PredictedItDoesNotReachBeyondTheValues) {
  EXPECT_EQ(predicted_quantile({3.0, 1.0, 2.0}, {}, 0.05), 1.0);
  EXPECT_EQ(predicted_quantile({3.0, 1.0, 2.0}, {}, 0.95), 3.0);
}

TEST(Quantile, AValueWithoutWeightIsAsIfItWereNotThere) {
  EXPECT_EQ(predicted_quantile({1.0, 2.0, 3.0, 100.0}, {1.0, 1.0, 1.0, 0.0}, 0.95), 3.0);
  EXPECT_EQ(predicted_quantile({1.0, 2.0, 3.0}, {0.0, 0.5, 0.0}, 0.05), 2.0);
}

TEST(Quantile, PredictedItLeavesOutTheLightestThousandth) {
  // Eight values that weigh, among many at the ends that hardly do: 19 would be needed to reach 5 and 95 %.
  std::vector<double> values, weights;
  for (int i = 0; i < 100; ++i) {
    values.push_back(i);
    weights.push_back(i >= 40 && i < 48 ? 1.0 : 1e-6);
  }
  EXPECT_EQ(predicted_quantile(values, weights, 0.05), 40.0);
  EXPECT_EQ(predicted_quantile(values, weights, 0.95), 47.0);
  // Of values that weigh alike none is left out, however many they are.
  const std::vector<double> alike(values.size() * 50, 1.0);
  std::vector<double> many;
  for (int i = 0; i < 50; ++i) many.insert(many.end(), values.begin(), values.end());
  EXPECT_EQ(predicted_quantile(many, alike, 0.0), 0.0);
  EXPECT_EQ(predicted_quantile(many, alike, 1.0), 99.0);
}

TEST(Quantile, IsDrawnToTheHeavyValue) {
  // Middles of the weights at 0.5, 3 and 5.5 of 6; a quarter of 6 is moved by a quarter of 18 / 6, for so few values.
  EXPECT_EQ(predicted_quantile({1.0, 2.0, 10.0}, {1.0, 4.0, 1.0}, 0.5), 2.0);
  EXPECT_DOUBLE_EQ(predicted_quantile({1.0, 2.0, 10.0}, {1.0, 4.0, 1.0}, 0.25), 1.1);
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
  EXPECT_EQ(of->low, 0.0) << "of five values nine of ten are all";
  EXPECT_EQ(of->high, 4.0);
}

TEST(Estimate, GivesWayToTheTissueThatExcludesIt) {
  Estimate leak{58.0, Interval{52.0, 64.0}, Interval{21.2, 37.4}};
  EXPECT_TRUE(tissue_excludes_value(leak));
  EXPECT_EQ(words_of(leak).value, "21 to 37");
  EXPECT_EQ(words_of(leak).interval, "58");
  EXPECT_EQ(words_of(leak).cause, "with the tissue of its file");
  leak.tissue = Interval{30.0, 36.0};  // narrower than the error of the computation
  EXPECT_EQ(widest(leak), ErrorCause::Tissue);
  leak.tissue = Interval{21.2, 53.0};
  EXPECT_FALSE(tissue_excludes_value(leak)) << "the computation may be so far off";
  leak.numerical.reset();
  EXPECT_TRUE(tissue_excludes_value(leak));
}

TEST(Estimate, IsSaidByItsWidestPart) {
  // The same in clients/web/test/unit/estimate.test.ts.
  const auto said = [](const Estimate& estimate) {
    const auto [value, interval, cause] = words_of(estimate);
    return value + " | " + interval + " | " + cause;
  };
  Estimate leak{0.3};
  EXPECT_EQ(said(leak), "0.3 |  | ");
  leak.numerical = Interval{0.0, 1.4};
  EXPECT_EQ(said(leak), "0.3 ± 1.1 |  | ± numerical error");
  leak.numerical = Interval{0.4, 1.5};
  EXPECT_EQ(said(leak), "0.3 | 0.4 to 1.5 | with numerical error (5 to 95 %)");
  leak.tissue = Interval{0.1, 3.5};
  EXPECT_EQ(said(leak), "0.3 | 0.1 to 3.5 | with tissue error (5 to 95 %)");
  leak.execution = Interval{0.0, 14.2};
  EXPECT_EQ(said(leak), "0 | 0 to 14 | with errors of execution (5 to 95 %)");
  EXPECT_EQ(said({0.31, {}, Interval{0.13, 0.44}}),
            "0.3 | 0.1 to 0.4 | with tissue error (5 to 95 %)");
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
