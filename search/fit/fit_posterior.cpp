#include "search/fit/fit_posterior.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>

namespace coapt {
namespace {

constexpr double kStep_sd = 0.5;  // prior standard deviations

/// Slope of the residuals over three values: central, or the flatter side where one is more than twice as steep: there a
/// leaflet buckles or another equilibrium begins, which says nothing of the slope here.
Eigen::VectorXd difference(const std::array<double, 3>& at, const Eigen::VectorXd& low,
                           const Eigen::VectorXd& middle, const Eigen::VectorXd& high) {
  constexpr double kSteeper = 2.0;
  if (at[0] == at[2]) return Eigen::VectorXd::Zero(middle.size());
  if (at[0] == at[1]) return (high - middle) / (at[2] - at[1]);
  if (at[2] == at[1]) return (middle - low) / (at[1] - at[0]);
  const Eigen::VectorXd below = (middle - low) / (at[1] - at[0]),
                        above = (high - middle) / (at[2] - at[1]);
  if (below.norm() > kSteeper * above.norm()) return above;
  if (above.norm() > kSteeper * below.norm()) return below;
  return 0.5 * (below + above);
}

}  // namespace

FitPosterior posterior_at(FitProblem& problem, const Eigen::VectorXd& point,
                          const FitWeights& weights) {
  const Eigen::Index m = point.size();
  std::vector<Eigen::VectorXd> sides;
  for (Eigen::Index i = 0; i < m; ++i) {
    const FitParameter& p = problem.parameters()[static_cast<std::size_t>(i)];
    const double step = kStep_sd * p.prior_sd / (p.upper - p.lower);
    for (const double way : {-1.0, 1.0}) {
      sides.push_back(point);
      sides.back()(i) = std::clamp(point(i) + way * step, 0.0, 1.0);
    }
  }
  sides.push_back(point);
  std::vector<FitAnswer> answers = problem.answers_with_leaks(sides);
  // A side that does not close says nothing: the other one has to do, or the prior.
  for (std::size_t i = 0; i + 1 < sides.size(); ++i)
    if (!answers[i].trusted) {
      sides[i] = point;
      answers[i] = answers.back();
    }
  std::vector<Eigen::VectorXd> residuals;
  for (std::size_t i = 0; i < sides.size(); ++i)
    residuals.push_back(problem.residual(sides[i], answers[i], weights));
  Eigen::MatrixXd jacobian(residuals.back().size(), m);
  Eigen::VectorXd leak_gradient = Eigen::VectorXd::Zero(m);
  for (Eigen::Index i = 0; i < m; ++i) {
    const auto low = static_cast<std::size_t>(2 * i), high = low + 1;
    const FitParameter& p = problem.parameters()[static_cast<std::size_t>(i)];
    const double scale = p.upper - p.lower;
    jacobian.col(i) = difference({sides[low](i) * scale, point(i) * scale, sides[high](i) * scale},
                                 residuals[low], residuals.back(), residuals[high]);
    if (sides[low](i) == sides[high](i)) {  // the prior alone
      jacobian(jacobian.rows() - m + i, i) = 1.0 / p.prior_sd;
      continue;
    }
    leak_gradient(i) = (answers[high].leak_mm2 - answers[low].leak_mm2) /
                       (scale * (sides[high](i) - sides[low](i)));
  }
  const Eigen::MatrixXd information = jacobian.transpose() * jacobian;
  FitPosterior posterior;
  posterior.covariance = information.ldlt().solve(Eigen::MatrixXd::Identity(m, m));
  posterior.leak_sd_mm2 =
      std::sqrt(std::max(0.0, leak_gradient.dot(posterior.covariance * leak_gradient)));
  return posterior;
}

}  // namespace coapt
