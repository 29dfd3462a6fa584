#include "lab/rivals/budgeted_cost.h"

#include <gtest/gtest.h>

#include <limits>

namespace coapt::rivals {
namespace {

constexpr double kRefused = std::numeric_limits<double>::infinity();

/// Costs 5 and 3 at y = 0; 4 and infinity at y = 1.
const LatticeTable kTable{"", {{"x", true, 2}, {"y", true, 2}}, {5, 3, 4, kRefused}};

TEST(BudgetedCost, SharesFallIntoBinsOfEqualWidth) {
  EXPECT_EQ(value_of(0.0, 4), 0);
  EXPECT_EQ(value_of(0.2499, 4), 0);
  EXPECT_EQ(value_of(0.25, 4), 1);
  EXPECT_EQ(value_of(0.75, 4), 3);
  EXPECT_EQ(value_of(1.0, 4), 3);
}

TEST(BudgetedCost, SharesOutsideOfTheRangeAreClamped) {
  EXPECT_EQ(value_of(-1e300, 4), 0);
  EXPECT_EQ(value_of(1e300, 4), 3);
  EXPECT_EQ(value_of(std::numeric_limits<double>::quiet_NaN(), 4), 0);
}

TEST(BudgetedCost, TheMiddleOfAValuesBinIsTheValue) {
  for (int count = 1; count <= kMostValues; ++count)
    for (int value = 0; value < count; ++value)
      ASSERT_EQ(value_of(share_of(value, count), count), value);
}

TEST(BudgetedCost, ACombinationAskedAgainIsFree) {
  BudgetedCost cost(kTable, 2);
  EXPECT_EQ(cost({0.1, 0.1}), 5.0);
  EXPECT_EQ(cost({0.4, 0.2}), 5.0);
  EXPECT_EQ(cost.evaluations(), 1);
  EXPECT_EQ(cost.calls(), 2);
  EXPECT_EQ(cost({0.9, 0.1}), 3.0);
  EXPECT_EQ(cost.evaluations(), 2);
}

TEST(BudgetedCost, AfterTheBudgetThereIsNothing) {
  BudgetedCost cost(kTable, 1);
  EXPECT_FALSE(cost.ended());
  EXPECT_EQ(cost({0.1, 0.1}), 5.0);
  EXPECT_TRUE(cost.ended());
  EXPECT_EQ(cost({0.9, 0.1}), std::nullopt);
  EXPECT_EQ(cost({0.1, 0.1}), std::nullopt);
  EXPECT_EQ(cost.evaluations(), 1);
}

TEST(BudgetedCost, ABudgetOfNothingGivesNothing) {
  EXPECT_EQ(BudgetedCost(kTable, 0)({0.1, 0.1}), std::nullopt);
}

TEST(BudgetedCost, TwentyCallsForEachEvaluationEndAStalledRival) {
  BudgetedCost cost(kTable, 2);
  for (int call = 0; call < 40; ++call) EXPECT_EQ(cost({0.1, 0.1}), 5.0);
  EXPECT_EQ(cost({0.9, 0.1}), std::nullopt);
  EXPECT_EQ(cost.evaluations(), 1);
}

TEST(BudgetedCost, AllPossibleCombinationsAreTheEndWhateverTheBudget) {
  BudgetedCost cost(kTable, 100);
  EXPECT_TRUE(cost({0.1, 0.1}) && cost({0.9, 0.1}) && cost({0.1, 0.9}));
  EXPECT_EQ(cost({0.1, 0.1}), std::nullopt);
}

TEST(BudgetedCost, AnImpossibleCombinationCostsTheGreatestFiniteCostAndNoEvaluation) {
  BudgetedCost cost(kTable, 4);
  EXPECT_EQ(cost({0.9, 0.9}), 5.0);
  EXPECT_EQ(cost.evaluations(), 0);
  EXPECT_TRUE(cost.improvements().empty());
}

TEST(BudgetedCost, TheSamePlanOfAnotherCombinationIsFree) {
  LatticeTable table = kTable;
  table.plans = {0, 1, 0, 2};
  BudgetedCost cost(table, 4);
  cost({0.1, 0.1});
  cost({0.1, 0.9});
  EXPECT_EQ(cost.evaluations(), 1);
  cost({0.9, 0.1});
  EXPECT_EQ(cost.evaluations(), 2);
  EXPECT_TRUE(cost.ended());
}

TEST(BudgetedCost, ImprovementsAreReportedAtOnceAndKept) {
  std::vector<Improvement> reported;
  BudgetedCost cost(kTable, 4, [&](const Improvement& i) { reported.push_back(i); });
  cost({0.9, 0.9});
  cost({0.1, 0.1});
  EXPECT_EQ(reported, (std::vector<Improvement>{{1, 5.0}}));
  cost({0.9, 0.1});
  cost({0.1, 0.9});
  EXPECT_EQ(reported, (std::vector<Improvement>{{1, 5.0}, {2, 3.0}}));
  EXPECT_EQ(cost.improvements(), reported);
}

}  // namespace
}  // namespace coapt::rivals
