#include "search/plans/ladder.h"

#include <gtest/gtest.h>

#include <cmath>

namespace coapt {
namespace {

TEST(Ladder, AStepThatRanksPlansAlikeIsKept) {
  const LadderStep step = measure_ladder_step(1, 5, {1.0, 2.0, 3.0}, {10.0, 20.0, 21.0});
  EXPECT_EQ(step.from, 1);
  EXPECT_EQ(step.to, 5);
  EXPECT_EQ(step.plans, 3);
  EXPECT_DOUBLE_EQ(step.spearman, 1.0);
  EXPECT_FALSE(step.skipped);
}

TEST(Ladder, AStepThatRanksPlansOtherwiseIsSkipped) {
  // Ranks 0 1 2 against 1 0 2: 1 - 6 (1 + 1 + 0) / (3 (9 - 1)) = 0.5.
  const LadderStep step = measure_ladder_step(5, 17, {1.0, 2.0, 3.0}, {2.0, 1.0, 3.0});
  EXPECT_DOUBLE_EQ(step.spearman, 0.5);
  EXPECT_TRUE(step.skipped);
}

TEST(Ladder, WithoutPlansNothingIsMeasuredAndNothingSkipped) {
  const LadderStep step = measure_ladder_step(0, 1, {}, {});
  EXPECT_EQ(step.plans, 0);
  EXPECT_TRUE(std::isnan(step.spearman));
  EXPECT_FALSE(step.skipped);
}

}  // namespace
}  // namespace coapt
