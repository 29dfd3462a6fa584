#include "search/plans/climb_model.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace coapt {
namespace {

constexpr std::size_t kLeastPlans = 6, kMostPlans = 300;
constexpr double kRidge = 0.01;
constexpr double kScatter = 0.05;  // of a closure's cost: other equilibria, nodes not taken
constexpr double kMostPart_mm2 = 100.0;

double kernel(const PlanRecord& a, const PlanRecord& b) {
  return std::exp(-0.5 * (a.place - b.place).squaredNorm());
}

}  // namespace

Eigen::VectorXd ClimbModel::signs(const PlanEvaluations& evaluations,
                                  const PlanRecord& plan) const {
  double mean = 0.0, worst = 0.0, tension = 0.0;
  for (const auto& [disturbance, closure] : plan.closures) {
    if (disturbance >= nodes_) break;
    const double leak = trusted(closure) ? closure.leak_mm2 : kMostPart_mm2;
    mean += std::min(leak, kMostPart_mm2) / nodes_;
    worst = std::max(worst, std::min(leak, kMostPart_mm2));
    if (trusted(closure)) tension = std::max(tension, closure.tension_max_n);
  }
  const double part =
      std::clamp(evaluations.guide(plan, nodes_) - plan.least_guide, 0.0, kMostPart_mm2);
  Eigen::VectorXd signs(5);
  signs << 1.0, std::sqrt(mean), std::sqrt(worst), tension, std::sqrt(part);
  return signs;
}

void ClimbModel::learn(const PlanEvaluations& evaluations,
                       const std::vector<const PlanRecord*>& plans) {
  std::vector<std::pair<double, const PlanRecord*>> order;
  for (const PlanRecord* plan : plans) order.emplace_back(evaluations.guide(*plan, goal_), plan);
  std::stable_sort(order.begin(), order.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  if (order.size() < kLeastPlans) return;
  order.resize(std::min(order.size(), kMostPlans));
  learnt_.clear();
  for (const auto& [cost, plan] : order) learnt_.push_back(plan);
  const Eigen::Index n = std::ssize(learnt_);
  Eigen::MatrixXd design(n, 5);
  Eigen::VectorXd rise(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const PlanRecord& plan = *learnt_[i];
    design.row(i) = signs(evaluations, plan);
    rise[i] = std::asinh(evaluations.guide(plan, goal_) - evaluations.guide(plan, nodes_));
  }
  const Eigen::MatrixXd normal =
      design.transpose() * design + kRidge * Eigen::MatrixXd::Identity(5, 5);
  weight_ = normal.ldlt().solve(design.transpose() * rise);
  const Eigen::VectorXd off = rise - design * weight_;
  variance_ = std::max(off.squaredNorm() / static_cast<double>(n), kScatter * kScatter);
  Eigen::MatrixXd covariance(n, n);
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = 0; j <= i; ++j)
      covariance(i, j) = covariance(j, i) =
          variance_ * kernel(*learnt_[i], *learnt_[j]) + (i == j ? kScatter * kScatter : 0.0);
  kernel_.emplace(covariance);
  missed_ = kernel_->solve(off);
}

ClimbModel::Expectation ClimbModel::expected(const PlanEvaluations& evaluations,
                                             const PlanRecord& plan) const {
  const double cost = evaluations.guide(plan, nodes_);
  if (learnt_.empty()) return {cost, cost, 0.0, 0.0, plan.least_guide};
  const Eigen::Index n = std::ssize(learnt_);
  Eigen::VectorXd near(n);
  for (Eigen::Index i = 0; i < n; ++i) near[i] = variance_ * kernel(plan, *learnt_[i]);
  const double rise = weight_.dot(signs(evaluations, plan)) + near.dot(missed_);
  const double left = variance_ - kernel_->matrixL().solve(near).squaredNorm();
  const double scatter = std::sqrt(std::max(0.0, left) + kScatter * kScatter);
  return {std::max(plan.least_guide, cost + std::sinh(rise)), cost, rise, scatter,
          plan.least_guide};
}

double ClimbModel::least(const Expectation& expected, double deviations) {
  return std::max(expected.bound,
                  expected.now + std::sinh(expected.rise - deviations * expected.scatter));
}

}  // namespace coapt
