#include "lab/verdicts/agreement.h"

#include <gtest/gtest.h>

#include <cmath>

namespace coapt {
namespace {

TEST(Kendall, OneSwapOfFourTakesTwoPairsOfSix) {
  const std::vector<double> order = {1, 2, 3, 4};
  EXPECT_DOUBLE_EQ(kendall_tau(count_pairs(order, order)), 1.0);
  EXPECT_DOUBLE_EQ(kendall_tau(count_pairs(order, {4, 3, 2, 1})), -1.0);
  EXPECT_DOUBLE_EQ(kendall_tau(count_pairs(order, {1, 3, 2, 4})), (5.0 - 1.0) / 6.0);
}

TEST(Kendall, TiesOfOneSideCountAgainstItAndOfBothSidesForNothing) {
  // Of {0, 0, 1, 2} against {0, 1, 2, 3} one pair of six is tied: 5 / sqrt(5 x 6).
  EXPECT_DOUBLE_EQ(kendall_tau(count_pairs({0, 0, 1, 2}, {0, 1, 2, 3})), 5.0 / std::sqrt(30.0));
  EXPECT_DOUBLE_EQ(kendall_tau(count_pairs({0, 0, 1, 2}, {5, 5, 6, 7})), 1.0);
  EXPECT_TRUE(std::isnan(kendall_tau(count_pairs({1, 1, 1}, {1, 2, 3}))));
}

TEST(Kendall, WhatLiesNearerThanTheTieIsTied) {
  const PairCount pairs = count_pairs({0.0, 0.05, 3.0}, {0.05, 0.0, 3.0}, 0.1);
  EXPECT_EQ(pairs.concordant, 2);
  EXPECT_EQ(pairs.discordant, 0);
  EXPECT_DOUBLE_EQ(kendall_tau(pairs), 1.0);
}

TEST(Kendall, PairsOfSeveralValvesAddUp) {
  PairCount pairs = count_pairs({1, 2}, {1, 2});
  pairs += count_pairs({1, 2, 3}, {3, 2, 1});
  EXPECT_EQ(pairs.concordant, 1);
  EXPECT_EQ(pairs.discordant, 3);
  EXPECT_DOUBLE_EQ(kendall_tau(pairs), -0.5);
}

TEST(Verdicts, AreCountedByWhatTheyGetWrong) {
  VerdictCount count;
  count.add(true, true);
  count.add(true, false);
  count.add(false, true);
  count.add(false, true);
  EXPECT_EQ(count.plans, 4);
  EXPECT_EQ(count.agree, 1);
  EXPECT_EQ(count.false_competent, 1);
  EXPECT_EQ(count.false_leaks, 2);
}

}  // namespace
}  // namespace coapt
