// oracle_answers: a question as JSON on standard input, coapt's answer on standard output (test_oracles.py asks).
#include <cmath>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

#include "io/json/json.h"
#include "search/least_squares.h"
#include "search/population/decision_tree.h"
#include "search/studies/sobol_indices.h"
#include "search/training/ability.h"

namespace coapt {
namespace {

using Rows = std::vector<std::vector<double>>;

Eigen::MatrixXd matrix(const Json& json) {
  const auto rows = json.get<Rows>();
  Eigen::MatrixXd made(std::ssize(rows), std::ssize(rows.front()));
  for (std::size_t r = 0; r < rows.size(); ++r)
    made.row(static_cast<Eigen::Index>(r)) =
        Eigen::Map<const Eigen::RowVectorXd>(rows[r].data(), std::ssize(rows[r]));
  return made;
}

Eigen::VectorXd vector(const Json& json) { return matrix(Json::array({json})).row(0); }

Json list(const Eigen::VectorXd& values) {
  return std::vector<double>(values.begin(), values.end());
}

Json sobol(const Json& asked) {
  const SobolIndices found =
      sobol_indices(asked["shares"].get<Rows>(), asked["values"].get<std::vector<double>>());
  return {{"first", found.first}, {"total", found.total}, {"q2", found.predicted_share}};
}

/// Residual i is the sum over k of weight(i, k) tanh(slope(i, k) x(k)), less target(i).
Json least_squares(const Json& asked) {
  const Eigen::MatrixXd weight = matrix(asked["weights"]), slope = matrix(asked["slopes"]);
  const Eigen::VectorXd target = vector(asked["targets"]);
  const auto residuals = [&](const std::vector<Eigen::VectorXd>& points) {
    std::vector<Eigen::VectorXd> all;
    for (const Eigen::VectorXd& x : points)
      all.emplace_back(
          (weight.array() * (slope * x.asDiagonal()).array().tanh()).rowwise().sum().matrix() -
          target);
    return all;
  };
  LeastSquaresOptions options;
  options.most_rounds = 200;
  options.least_difference = 1e-6;
  const LeastSquaresFit fit = fit_least_squares(residuals, vector(asked["start"]), options);
  return {{"point", list(fit.point)}, {"cost", fit.cost}};
}

Json tree(const Json& asked) {
  const DecisionTree grown = grow_tree({matrix(asked["features"]), matrix(asked["costs"])},
                                       {.most_leaves = asked["most_leaves"],
                                        .least_members = asked["least_members"],
                                        .rounding = {}});
  Json splits = Json::array();
  for (const TreeNode& node : grown.nodes)
    if (node.feature >= 0) splits.push_back({node.feature, node.threshold, node.members});
  return splits;
}

Json ability(const Json& asked) {
  std::vector<Response> responses;
  for (const Json& one : asked)
    responses.push_back({one["right"], one["difficulty"], one["chance"], one["slope"]});
  const Ability found = ability_of(responses);
  return {{"value", found.value}, {"sd", found.standard_error}};
}

Json calibration(const Json& asked) {
  const Eigen::MatrixXd right = matrix(asked["right"]);  // a row for each rater
  std::vector<RatedItem> rated;
  for (int r = 0; r < right.rows(); ++r)
    for (int i = 0; i < right.cols(); ++i) rated.push_back({r, i, right(r, i) > 0.5});
  Json difficulties = Json::array();
  for (const ItemFit& fit : calibrate(rated, static_cast<int>(right.rows()),
                                      static_cast<int>(right.cols()), {.chance = asked["chance"]}))
    difficulties.push_back(fit.difficulty);
  return difficulties;
}

Json answer(const Json& question) {
  const std::string& name = question.begin().key();
  const Json& asked = question.begin().value();
  if (name == "sobol") return sobol(asked);
  if (name == "least_squares") return least_squares(asked);
  if (name == "tree") return tree(asked);
  if (name == "ability") return ability(asked);
  return calibration(asked);
}

}  // namespace
}  // namespace coapt

int main() {
  const std::string text(std::istreambuf_iterator<char>(std::cin), {});
  std::cout << coapt::answer(coapt::Json::parse(text)).dump() << '\n';
}
