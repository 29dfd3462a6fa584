#include "search/preference/raters.h"

#include <gtest/gtest.h>

namespace coapt {
namespace {

using enum Preference;

TEST(Consistency, IsTheShareOfRepeatsAnsweredAlikeOnEitherSide) {
  EXPECT_FALSE(consistency({{{0, 0, 1}, First}, {{0, 1, 2}, First}})) << "no repeats";
  EXPECT_EQ(consistency({{{0, 0, 1}, First}, {{0, 1, 0}, Second}}), 1.0) << "the same plan";
  EXPECT_EQ(consistency(
                {{{0, 0, 1}, First}, {{0, 1, 0}, First}, {{1, 0, 1}, Unable}, {{1, 1, 0}, Unable}}),
            0.5);
}

// Of ten pairs both say the higher one five times and the lower one three times, and differ in two: observed 0.8, by chance
// 0.6 * 0.6 + 0.4 * 0.4 = 0.52, kappa = 0.28 / 0.48.
TEST(Agreement, KappaOfTwoRatersIsThatWorkedOutByHand) {
  std::vector<GivenAnswer> one, other;
  for (int plan = 1; plan <= 10; ++plan) {
    one.push_back({{0, 0, plan}, plan <= 6 ? First : Second});
    other.push_back({{0, plan, 0}, plan <= 5 || plan == 10 ? Second : First});
  }
  const Agreement result = agreement(one, other);
  EXPECT_EQ(result.pairs, 10);
  EXPECT_DOUBLE_EQ(result.share, 0.8);
  ASSERT_TRUE(result.kappa);
  EXPECT_NEAR(*result.kappa, 0.28 / 0.48, 1e-14);
}

TEST(Agreement, IsNoneWithoutCommonPairsOrWithOneAnswerForAll) {
  EXPECT_EQ(agreement({{{0, 0, 1}, First}}, {{{1, 0, 1}, First}}).pairs, 0);
  EXPECT_FALSE(agreement({{{0, 0, 1}, First}}, {{{1, 0, 1}, First}}).kappa);
  const Agreement constant = agreement({{{0, 0, 1}, First}}, {{{0, 0, 1}, First}});
  EXPECT_EQ(constant.share, 1.0);
  EXPECT_FALSE(constant.kappa);
}

}  // namespace
}  // namespace coapt
