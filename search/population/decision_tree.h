// A decision tree that chooses a repair from what an echo shows: grown where a choice costs least, not where classes are purest.
//
// Each split asks one feature; each leaf chooses the candidate of the lowest mean cost among its members. Growth is
// best first: of all leaves and all splits of them (every feature, every value between two members) the one that lowers the
// summed cost most (CART, Breiman 1984, with the cost of a wrong choice for its impurity). Thresholds are rounded to what can be
// read off an echo, before they are judged. Limits: greedy, so a split that pays only with the next one is not found.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace coapt {

struct TreeData {
  Eigen::MatrixXd features;  ///< members x features, finite
  Eigen::MatrixXd costs;     ///< members x candidates, finite
};

/// The rows of `data`, in that order.
TreeData rows_of(const TreeData& data, const std::vector<int>& rows);

struct TreeOptions {
  int most_leaves = 8;
  int least_members = 5;         ///< of a leaf
  std::vector<double> rounding;  ///< of each feature's thresholds; empty: none
};

/// Index 0 is the root. A leaf has no feature.
struct TreeNode {
  int feature = -1;
  double threshold = 0.0;      ///< members with less go to `below`, others to `above`
  int below = -1, above = -1;  ///< nodes
  int choice = 0;              ///< the candidate of the lowest mean cost here
  int members = 0;             ///< that it was grown on
};
struct DecisionTree {
  std::vector<TreeNode> nodes;
};

/// @pre data has members and candidates.
DecisionTree grow_tree(const TreeData& data, const TreeOptions& options);

/// The tree without splits that do not lower the summed cost of members that it was not grown on. Nodes stay in order.
DecisionTree pruned(const DecisionTree& tree, const TreeData& data);

/// The leaf that a member comes to.
int leaf_of(const DecisionTree& tree, const Eigen::RowVectorXd& features);
int leaves(const DecisionTree& tree);

/// The candidate of the lowest mean cost over all members.
int best_single_choice(const TreeData& data);

}  // namespace coapt
