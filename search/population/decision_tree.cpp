#include "search/population/decision_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace coapt {
namespace {

struct Split {
  int feature = -1;
  double threshold = 0.0;
  double gain = 0.0;  // of the summed cost
};

struct GrowingLeaf {
  int node = 0;
  std::vector<int> rows;
  Split best;
};

Eigen::RowVectorXd summed_costs(const TreeData& data, const std::vector<int>& rows) {
  Eigen::RowVectorXd sum = Eigen::RowVectorXd::Zero(data.costs.cols());
  for (const int row : rows) sum += data.costs.row(row);
  return sum;
}

double rounded_threshold(double low, double high, double rounding) {
  const double middle = 0.5 * (low + high);
  return rounding > 0.0 ? rounding * std::round(middle / rounding) : middle;
}

Split best_split(const TreeData& data, const std::vector<int>& rows, const TreeOptions& options) {
  const Eigen::RowVectorXd all = summed_costs(data, rows);
  const double now = all.minCoeff();
  Split best;
  for (int f = 0; f < data.features.cols(); ++f) {
    std::vector<int> order = rows;
    std::stable_sort(order.begin(), order.end(),
                     [&](int a, int b) { return data.features(a, f) < data.features(b, f); });
    Eigen::RowVectorXd below = Eigen::RowVectorXd::Zero(data.costs.cols());
    const double rounding =
        options.rounding.empty() ? 0.0 : options.rounding[static_cast<std::size_t>(f)];
    for (std::size_t i = 0; i + 1 < order.size(); ++i) {
      below += data.costs.row(order[i]);
      const double low = data.features(order[i], f), high = data.features(order[i + 1], f);
      const int count = static_cast<int>(i) + 1, rest = static_cast<int>(order.size()) - count;
      if (!(low < high) || count < options.least_members || rest < options.least_members) continue;
      const double threshold = rounded_threshold(low, high, rounding);
      if (!(low < threshold && threshold <= high)) continue;
      const double gain = now - below.minCoeff() - (all - below).minCoeff();
      if (gain > best.gain) best = {f, threshold, gain};
    }
  }
  return best;
}

int cheapest(const Eigen::RowVectorXd& costs) {
  Eigen::Index index = 0;
  costs.minCoeff(&index);
  return static_cast<int>(index);
}

int add_node(const TreeData& data, const std::vector<int>& rows, DecisionTree& tree) {
  TreeNode node;
  node.choice = cheapest(summed_costs(data, rows));
  node.members = static_cast<int>(rows.size());
  tree.nodes.push_back(node);
  return static_cast<int>(tree.nodes.size()) - 1;
}

/// Copies the part below `node`, pruned; returns its summed cost over `rows`.
double copy_pruned(const DecisionTree& tree, int node, const TreeData& data,
                   const std::vector<int>& rows, DecisionTree& out) {
  const TreeNode& from = tree.nodes[static_cast<std::size_t>(node)];
  const std::size_t at = out.nodes.size();
  out.nodes.push_back(from);
  double own = 0.0;
  for (const int row : rows) own += data.costs(row, from.choice);
  if (from.feature < 0) return own;
  std::vector<int> below, above;
  for (const int row : rows)
    (data.features(row, from.feature) < from.threshold ? below : above).push_back(row);
  const int first = static_cast<int>(out.nodes.size());
  double split = copy_pruned(tree, from.below, data, below, out);
  const int second = static_cast<int>(out.nodes.size());
  split += copy_pruned(tree, from.above, data, above, out);
  TreeNode& made = out.nodes[at];
  made.below = first;
  made.above = second;
  if (split < own) return split;
  out.nodes.resize(at + 1);
  made.feature = made.below = made.above = -1;
  return own;
}

std::vector<int> all_rows(const TreeData& data) {
  std::vector<int> rows(static_cast<std::size_t>(data.costs.rows()));
  std::iota(rows.begin(), rows.end(), 0);
  return rows;
}

}  // namespace

TreeData rows_of(const TreeData& data, const std::vector<int>& rows) {
  TreeData part;
  part.features.resize(std::ssize(rows), data.features.cols());
  part.costs.resize(std::ssize(rows), data.costs.cols());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    part.features.row(static_cast<Eigen::Index>(i)) = data.features.row(rows[i]);
    part.costs.row(static_cast<Eigen::Index>(i)) = data.costs.row(rows[i]);
  }
  return part;
}

DecisionTree grow_tree(const TreeData& data, const TreeOptions& options) {
  DecisionTree tree;
  std::vector<GrowingLeaf> growing;
  const auto add_leaf = [&](std::vector<int> rows) {
    const int node = add_node(data, rows, tree);
    const Split split = best_split(data, rows, options);
    growing.push_back({node, std::move(rows), split});
    return node;
  };
  add_leaf(all_rows(data));
  while (std::ssize(growing) < options.most_leaves) {
    const auto next = std::max_element(
        growing.begin(), growing.end(),
        [](const GrowingLeaf& a, const GrowingLeaf& b) { return a.best.gain < b.best.gain; });
    if (next->best.feature < 0) break;
    const GrowingLeaf leaf = std::move(*next);
    growing.erase(next);
    std::vector<int> below, above;
    for (const int row : leaf.rows)
      (data.features(row, leaf.best.feature) < leaf.best.threshold ? below : above).push_back(row);
    const int first = add_leaf(std::move(below)), second = add_leaf(std::move(above));
    TreeNode& node = tree.nodes[static_cast<std::size_t>(leaf.node)];
    node.feature = leaf.best.feature;
    node.threshold = leaf.best.threshold;
    node.below = first;
    node.above = second;
  }
  return tree;
}

DecisionTree pruned(const DecisionTree& tree, const TreeData& data) {
  DecisionTree out;
  copy_pruned(tree, 0, data, all_rows(data), out);
  return out;
}

int leaf_of(const DecisionTree& tree, const Eigen::RowVectorXd& features) {
  int at = 0;
  while (tree.nodes[static_cast<std::size_t>(at)].feature >= 0) {
    const TreeNode& node = tree.nodes[static_cast<std::size_t>(at)];
    at = features[node.feature] < node.threshold ? node.below : node.above;
  }
  return at;
}

int leaves(const DecisionTree& tree) {
  return static_cast<int>(std::count_if(tree.nodes.begin(), tree.nodes.end(),
                                        [](const TreeNode& node) { return node.feature < 0; }));
}

int best_single_choice(const TreeData& data) { return cheapest(data.costs.colwise().sum()); }

}  // namespace coapt
