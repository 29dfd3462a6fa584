#include "search/training/binomial.h"

#include <gtest/gtest.h>

#include <cmath>

namespace coapt {
namespace {

TEST(Binomial, ChanceOfAllRightIsThePower) {
  EXPECT_NEAR(chance_of_at_least(3, 3, 0.25), 1.0 / 64.0, 1e-12);
  EXPECT_NEAR(chance_of_at_least(0, 3, 0.25), 1.0, 1e-12);
  // 2 or 3 of 3: 3 x 1/16 x 3/4 + 1/64.
  EXPECT_NEAR(chance_of_at_least(2, 3, 0.25), 10.0 / 64.0, 1e-12);
}

TEST(Binomial, IntervalsAreWilsons) {
  // No right one of n: from 0 to z2 / (n + z2).
  const double z2 = std::pow(normal_quantile(0.975), 2);
  EXPECT_NEAR(share_interval(0, 10)[0], 0.0, 1e-12);
  EXPECT_NEAR(share_interval(0, 10)[1], z2 / (10.0 + z2), 1e-9);
  const auto half = share_interval(50, 100);
  EXPECT_NEAR(half[0] + half[1], 1.0, 1e-9);
}

TEST(Power, NeedsTheAnswersOfTheTableForTeachers) {  // docs/training.md
  EXPECT_EQ(answers_to_tell(0.25, 0.45, 0.8), 89);
  EXPECT_EQ(answers_to_tell(0.25, 0.63, 0.8), 26);
  EXPECT_EQ(answers_to_tell(0.33, 0.44, 0.8), 306);
  EXPECT_EQ(answers_to_tell(0.44, 0.33, 0.8), 306);
}

TEST(NormalQuantile, IsThatOfTheTables) {
  EXPECT_NEAR(normal_quantile(0.5), 0.0, 1e-9);
  EXPECT_NEAR(normal_quantile(0.975), 1.959963985, 1e-8);
}

}  // namespace
}  // namespace coapt
