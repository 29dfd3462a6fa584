// What a plan that was closed at few nodes is expected to cost at more.
//
// A plan leaks least as planned, so few nodes flatter it. By how much, two things tell: the few
// closures themselves (a leak of a tenth of a square millimetre as planned is the edge of a large
// one nearby), and plans that put the valve in a similar place and have climbed. Regression on the
// former, a Gaussian process over the latter for what it misses (Rasmussen and Williams 2006, 2.7),
// both on asinh of the rise.
#pragma once

#include <Eigen/Cholesky>
#include <optional>
#include <vector>

#include "search/plans/plan_evaluations.h"

namespace coapt {

class ClimbModel {
 public:
  /// From `nodes` to `goal` nodes; expects no rise until it has learnt from enough plans.
  ClimbModel(int nodes, int goal) : nodes_(nodes), goal_(goal) {}

  /// @param plans closed at `goal` nodes. Of many, the cheapest there are learnt from.
  void learn(const PlanEvaluations& evaluations, const std::vector<const PlanRecord*>& plans);

  struct Expectation {
    double cost = 0.0;
    double now = 0.0;                  ///< what it costs at the nodes closed
    double rise = 0.0, scatter = 0.0;  ///< mean and sd of asinh(cost - now)
    double bound = 0.0;                ///< it cannot cost less
  };
  /// So many standard deviations better than expected.
  static double least(const Expectation& expected, double deviations);

  /// At `goal` nodes. @pre the plan is possible and closed at `nodes`.
  Expectation expected(const PlanEvaluations& evaluations, const PlanRecord& plan) const;

 private:
  Eigen::VectorXd signs(const PlanEvaluations& evaluations, const PlanRecord& plan) const;

  int nodes_, goal_;
  std::vector<const PlanRecord*> learnt_;
  Eigen::VectorXd weight_;  // of the signs
  double variance_ = 0.0;   // of what they miss
  std::optional<Eigen::LLT<Eigen::MatrixXd>> kernel_;
  Eigen::VectorXd missed_;  // kernel^-1 x what the regression misses
};

}  // namespace coapt
