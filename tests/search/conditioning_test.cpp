#include "search/conditioning.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>

namespace coapt {
namespace {

std::optional<ModelFigures> leaking(double mm2, double sd_mm2 = 0.0) {
  return ModelFigures{{mm2, 100.0, 2.0}, {sd_mm2, 0.0, 0.0}};
}

const std::vector<Observation> kThirty = {{ObservedFigure::Leak, 30.0, 10.0, ""}};

TEST(Conditioning, WithoutObservationsAllThatCloseWeighAlike) {
  const Conditioning found = condition({}, {leaking(1.0), std::nullopt, leaking(50.0)});
  EXPECT_EQ(found.weights, (std::vector<double>{0.5, 0.0, 0.5}));
  EXPECT_NEAR(found.effective, 2.0, 1e-12);
  EXPECT_FALSE(found.contradicts);
}

TEST(Conditioning, WeighsByTheNormalLikelihood) {
  const Conditioning found = condition(kThirty, {leaking(30.0), leaking(40.0), leaking(10.0)});
  EXPECT_NEAR(found.weights[1] / found.weights[0], std::exp(-0.5), 1e-12);  // one sd off
  EXPECT_NEAR(found.weights[2] / found.weights[0], std::exp(-2.0), 1e-12);  // two
  EXPECT_NEAR(std::accumulate(found.weights.begin(), found.weights.end(), 0.0), 1.0, 1e-12);
  EXPECT_GT(found.effective, 1.0);
  EXPECT_LT(found.effective, 3.0);
}

TEST(Conditioning, CountsTheNumericalErrorOfADraw) {
  const Conditioning found =
      condition({{ObservedFigure::Leak, 30.0, 3.0, ""}}, {leaking(30.0, 4.0), leaking(40.0, 4.0)});
  EXPECT_NEAR(found.weights[1] / found.weights[0], std::exp(-0.5 * 4.0), 1e-12);  // 10 of 5 mm2
}

TEST(Conditioning, MultipliesWhatWasObservedOfSeveralFigures) {
  const std::vector<Observation> both = {kThirty[0], {ObservedFigure::WidestGap, 3.0, 1.0, ""}};
  const Conditioning found = condition(both, {leaking(30.0), leaking(40.0)});
  EXPECT_NEAR(found.weights[1] / found.weights[0], std::exp(-0.5), 1e-12);  // the gap is as far off
}

TEST(Conditioning, SaysWhereNoDrawFitsAndWeighsNothing) {
  EXPECT_FALSE(condition(kThirty, {leaking(59.0), leaking(70.0)}).contradicts);
  const Conditioning found = condition(kThirty, {leaking(61.0), std::nullopt, leaking(90.0)});
  EXPECT_TRUE(found.contradicts);
  EXPECT_EQ(found.weights, (std::vector<double>{0.5, 0.0, 0.5}));
}

TEST(Conditioning, OfAFigureThatIsNoNumberIsFarAway) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Conditioning found = condition(kThirty, {leaking(nan), leaking(30.0)});
  EXPECT_EQ(found.weights, (std::vector<double>{0.0, 1.0}));
  EXPECT_TRUE(condition(kThirty, {leaking(nan)}).contradicts);
}

TEST(Conditioning, OfNoDrawsIsEmpty) {
  EXPECT_EQ(condition(kThirty, {std::nullopt}).effective, 0.0);
  EXPECT_FALSE(condition(kThirty, {}).contradicts);
}

TEST(Conditioning, ResamplesAsOftenAsADrawWeighs) {
  EXPECT_EQ(resampled({0.25, 0.25, 0.25, 0.25}, 4), (std::vector<int>{0, 1, 2, 3}));
  EXPECT_EQ(resampled({0.0, 0.75, 0.0, 0.25, 0.0}, 4), (std::vector<int>{1, 1, 1, 3}));
  EXPECT_EQ(resampled({0.0, 1.0, 0.0}, 3), (std::vector<int>{1, 1, 1}));
}

TEST(Conditioning, IsBayesRuleForANormalPrior) {
  // Leaks of 0 to 80 mm2 by a normal prior (40, 15), seen at 30 with an sd of 10: mean and sd of the product of both.
  std::vector<std::optional<ModelFigures>> draws;
  std::vector<double> leaks;
  for (int i = 0; i < 4000; ++i) {  // at quantiles of the prior, by bisection
    double low = -60.0, high = 140.0;
    while (high - low > 1e-9) {
      const double middle = 0.5 * (low + high);
      const double share = 0.5 * std::erfc(-(middle - 40.0) / (15.0 * std::sqrt(2.0)));
      (share < (i + 0.5) / 4000.0 ? low : high) = middle;
    }
    leaks.push_back(low);
    draws.push_back(leaking(low));
  }
  const Conditioning found = condition(kThirty, draws);
  double mean = 0.0, variance = 0.0;
  for (std::size_t i = 0; i < leaks.size(); ++i) mean += found.weights[i] * leaks[i];
  for (std::size_t i = 0; i < leaks.size(); ++i)
    variance += found.weights[i] * std::pow(leaks[i] - mean, 2);
  EXPECT_NEAR(mean, (40.0 / 225.0 + 30.0 / 100.0) / (1.0 / 225.0 + 1.0 / 100.0), 0.01);
  EXPECT_NEAR(std::sqrt(variance), std::sqrt(1.0 / (1.0 / 225.0 + 1.0 / 100.0)), 0.01);
}

}  // namespace
}  // namespace coapt
