#include "search/studies/sobol_indices.h"

#include <gtest/gtest.h>

#include <cmath>

#include "search/latin_hypercube.h"

namespace coapt {
namespace {

template <class Function>
SobolIndices indices_of(const Function& function, int factors = 2, int count = 60) {
  const std::vector<std::vector<double>> shares = latin_hypercube(count, factors, 3);
  std::vector<double> values;
  for (const std::vector<double>& share : shares) values.push_back(function(share));
  return sobol_indices(shares, values);
}

TEST(SobolIndices, OfASumAreTheSquaresOfItsWeights) {
  const SobolIndices found =
      indices_of([](const std::vector<double>& x) { return 2.0 * x[0] + x[1]; });
  EXPECT_NEAR(found.first[0], 0.8, 1e-9);
  EXPECT_NEAR(found.first[1], 0.2, 1e-9);
  EXPECT_NEAR(found.total[0], 0.8, 1e-9);
  EXPECT_NEAR(found.total[1], 0.2, 1e-9);
  EXPECT_NEAR(found.predicted_share, 1.0, 1e-9);
  EXPECT_NEAR(found.effect[0], 2.0, 1e-9);
  EXPECT_NEAR(found.effect[1], 1.0, 1e-9);
}

TEST(SobolIndices, OfAPureInteractionAreTotalOnly) {
  const SobolIndices found =
      indices_of([](const std::vector<double>& x) { return (x[0] - 0.5) * (x[1] - 0.5); }, 3);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_NEAR(found.first[i], 0.0, 1e-9);
    EXPECT_NEAR(found.total[i], 1.0, 1e-9);
  }
  EXPECT_NEAR(found.total[2], 0.0, 1e-9) << "it does not enter";
}

TEST(SobolIndices, OfAProductAreAsByHand) {
  // x y: 7/144, of which 1/48 by each alone and 1/144 together.
  const SobolIndices found = indices_of([](const std::vector<double>& x) { return x[0] * x[1]; });
  EXPECT_NEAR(found.first[0], 3.0 / 7.0, 1e-9);
  EXPECT_NEAR(found.total[0], 4.0 / 7.0, 1e-9);
  EXPECT_NEAR(found.effect[0], 0.5, 1e-9) << "in the middle of the other factor";
}

TEST(SobolIndices, OfALinearFunctionNeedFewSamples) {
  // 8 factors, 12 samples: only the linear set of terms fits.
  const std::vector<double> weights = {1.0, -2.0, 0.0, 3.0, 0.5, 0.0, 1.0, -1.0};
  double squares = 0.0;
  for (const double weight : weights) squares += weight * weight;
  const SobolIndices found = indices_of(
      [&](const std::vector<double>& x) {
        double sum = 4.0;
        for (std::size_t f = 0; f < weights.size(); ++f) sum += weights[f] * x[f];
        return sum;
      },
      8, 12);
  for (std::size_t f = 0; f < weights.size(); ++f) {
    EXPECT_NEAR(found.first[f], weights[f] * weights[f] / squares, 1e-9) << f;
    EXPECT_NEAR(found.total[f], weights[f] * weights[f] / squares, 1e-9) << f;
    EXPECT_NEAR(found.effect[f], weights[f], 1e-9) << f;
  }
  EXPECT_NEAR(found.predicted_share, 1.0, 1e-9);
}

TEST(SobolIndices, OfASquareAreItsFactorsAlone) {
  const SobolIndices found =
      indices_of([](const std::vector<double>& x) { return std::pow(x[1] - 0.3, 2); });
  EXPECT_NEAR(found.first[1], 1.0, 1e-9);
  EXPECT_NEAR(found.total[0], 0.0, 1e-9);
  EXPECT_NEAR(found.effect[1], 0.49 - 0.09, 1e-9);
}

TEST(SobolIndices, ThatPredictNothingSaySo) {
  // Nothing of second degree looks like this; the hypercube's own order is random.
  const SobolIndices found = indices_of(
      [](const std::vector<double>& x) { return std::sin(1e4 * x[0]) + std::sin(1e4 * x[1]); });
  EXPECT_LT(found.predicted_share, 0.3);
}

TEST(SobolIndices, OfTooFewSamplesAreNotKnown) {
  const auto sum = [](const std::vector<double>& x) { return x[0] + x[1]; };
  const SobolIndices few = indices_of(sum, 2, 3);
  ASSERT_EQ(few.first.size(), 2u);
  for (const double index :
       {few.first[0], few.first[1], few.total[0], few.effect[0], few.predicted_share})
    EXPECT_TRUE(std::isnan(index));
  EXPECT_FALSE(std::isnan(indices_of(sum, 2, 4).first[0]));
  EXPECT_TRUE(sobol_indices({}, {}).first.empty());
}

TEST(SobolIndices, OfAConstantAreNotKnown) {
  for (const double constant : {0.0, 1.0, 0.1, -7.3, 1e9 / 3.0}) {
    const SobolIndices found = indices_of([=](const std::vector<double>&) { return constant; });
    EXPECT_TRUE(std::isnan(found.first[0])) << constant;
    EXPECT_TRUE(std::isnan(found.total[1])) << constant;
  }
}

}  // namespace
}  // namespace coapt
