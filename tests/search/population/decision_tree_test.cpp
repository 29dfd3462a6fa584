#include "search/population/decision_tree.h"

#include <gtest/gtest.h>

#include "search/population/bootstrap.h"

namespace coapt {
namespace {

TEST(DecisionTree, SplitsWhereTheCheaperRepairChanges) {
  // One feature; the first repair is right below 2.5, the second above.
  TreeData data{Eigen::MatrixXd(4, 1), Eigen::MatrixXd(4, 2)};
  data.features << 1.0, 2.0, 3.0, 4.0;
  data.costs << 0.0, 5.0, 1.0, 4.0, 6.0, 0.0, 7.0, 1.0;
  const DecisionTree tree = grow_tree(data, {.most_leaves = 8, .least_members = 1, .rounding = {}});
  ASSERT_EQ(tree.nodes.size(), 3u);
  EXPECT_EQ(tree.nodes[0].feature, 0);
  EXPECT_DOUBLE_EQ(tree.nodes[0].threshold, 2.5);
  EXPECT_EQ(tree.nodes[static_cast<std::size_t>(tree.nodes[0].below)].choice, 0);
  EXPECT_EQ(tree.nodes[static_cast<std::size_t>(tree.nodes[0].above)].choice, 1);
  EXPECT_EQ(leaves(tree), 2);
}

TEST(DecisionTree, WeighsMistakesByTheirCostNotByTheirNumber) {
  // The second repair is cheaper for two of three, but ruinous for the third: for all, the first.
  TreeData data{Eigen::MatrixXd::Zero(3, 1), Eigen::MatrixXd(3, 2)};
  data.costs << 2.0, 1.0, 2.0, 1.0, 2.0, 50.0;
  EXPECT_EQ(best_single_choice(data), 0);
  const DecisionTree tree = grow_tree(data, {});
  EXPECT_EQ(leaves(tree), 1);  // a feature that is the same for all cannot be asked for
  EXPECT_EQ(tree.nodes[0].choice, 0);
}

TEST(DecisionTree, KeepsWithinItsLeavesAndTakesTheGreatestGainFirst) {
  // Three groups; asking for the second feature saves 20, for the first 2 in what is left.
  TreeData data{Eigen::MatrixXd(6, 2), Eigen::MatrixXd(6, 3)};
  data.features << 0, 0, 0, 0, 1, 0, 1, 0, 0, 1, 1, 1;
  data.costs << 0, 1, 10, 0, 1, 10, 1, 0, 10, 1, 0, 10, 10, 10, 0, 10, 10, 0;
  const TreeOptions two{.most_leaves = 2, .least_members = 1, .rounding = {}};
  const DecisionTree small = grow_tree(data, two);
  EXPECT_EQ(leaves(small), 2);
  EXPECT_EQ(small.nodes[0].feature, 1);
  const DecisionTree whole =
      grow_tree(data, {.most_leaves = 8, .least_members = 1, .rounding = {}});
  EXPECT_EQ(leaves(whole), 3);
  for (int row = 0; row < 6; ++row)
    EXPECT_EQ(
        data.costs(
            row,
            whole.nodes[static_cast<std::size_t>(leaf_of(whole, data.features.row(row)))].choice),
        0.0);
}

TEST(DecisionTree, RoundsThresholdsToWhatAnEchoShows) {
  TreeData data{Eigen::MatrixXd(2, 1), Eigen::MatrixXd(2, 2)};
  data.features << 1.02, 1.31;
  data.costs << 0.0, 1.0, 1.0, 0.0;
  const DecisionTree tree =
      grow_tree(data, {.most_leaves = 2, .least_members = 1, .rounding = {0.1}});
  EXPECT_NEAR(tree.nodes[0].threshold, 1.2, 1e-12);
}

TEST(DecisionTree, PruningTakesBackASplitThatOtherMembersDoNotBearOut) {
  TreeData grown{Eigen::MatrixXd(2, 1), Eigen::MatrixXd(2, 2)};
  grown.features << 0.0, 1.0;
  grown.costs << 0.0, 1.0, 1.5, 0.0;
  const DecisionTree tree =
      grow_tree(grown, {.most_leaves = 2, .least_members = 1, .rounding = {}});
  ASSERT_EQ(leaves(tree), 2);
  EXPECT_EQ(leaves(pruned(tree, grown)), 2);
  TreeData others = grown;
  others.costs << 1.0, 0.0, 1.0, 0.0;  // the second repair throughout, which the root would choose
  const DecisionTree left = pruned(tree, others);
  EXPECT_EQ(leaves(left), 1);
  EXPECT_EQ(left.nodes[0].choice, 1);
}

TEST(MeanInterval, OfOneValueIsThatValueAndOfManyHoldsTheMean) {
  const std::vector<double> one = {3.0}, many = {0.0, 1.0, 2.0, 3.0, 4.0};
  EXPECT_EQ(mean_interval(one).low, 3.0);
  const MeanInterval interval = mean_interval(many);
  EXPECT_DOUBLE_EQ(interval.mean, 2.0);
  // sqrt(2 / 5) is the sd of the mean: 1.96 of it on either side, in steps of 0.2.
  EXPECT_NEAR(interval.low, 2.0 - 1.24, 0.21);
  EXPECT_NEAR(interval.high, 2.0 + 1.24, 0.21);
}

}  // namespace
}  // namespace coapt
