#include "search/least_squares.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>

namespace coapt {
namespace {

constexpr std::array<double, 8> kDamping = {0.03, 0.1, 0.3, 1.0, 3.0, 10.0, 30.0, 100.0};
constexpr double kShrink = 0.6;  // of the differences after a round without success

struct Best {
  Eigen::VectorXd point, residual;
  double cost = 0.0;

  /// Takes the best of some points; whether it is better than before.
  bool improve(const std::vector<Eigen::VectorXd>& points,
               const std::vector<Eigen::VectorXd>& residuals) {
    bool better = false;
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (residuals[i].squaredNorm() >= cost) continue;
      point = points[i];
      residual = residuals[i];
      cost = residual.squaredNorm();
      better = true;
    }
    return better;
  }
};

/// The damped step from `at`, axes that would leave the cube held at its faces.
Eigen::VectorXd damped_step(const Eigen::MatrixXd& jacobian, const Eigen::VectorXd& residual,
                            const Eigen::VectorXd& at, double damping) {
  const Eigen::Index n = at.size();
  Eigen::VectorXd step = Eigen::VectorXd::Zero(n);
  std::vector<Eigen::Index> free;
  for (Eigen::Index i = 0; i < n; ++i) free.push_back(i);
  while (!free.empty()) {
    for (const Eigen::Index i : free) step(i) = 0.0;
    const Eigen::MatrixXd columns = jacobian(Eigen::all, free);
    Eigen::MatrixXd normal = columns.transpose() * columns;
    normal.diagonal().array() += damping;
    const Eigen::VectorXd moves =
        normal.ldlt().solve(-columns.transpose() * (residual + jacobian * step));
    std::vector<Eigen::Index> inside;
    for (Eigen::Index k = 0; k < std::ssize(free); ++k) {
      const Eigen::Index i = free[k];
      const double end = at(i) + moves(k);
      step(i) = std::clamp(end, 0.0, 1.0) - at(i);
      if (end >= 0.0 && end <= 1.0) inside.push_back(i);
    }
    if (inside.size() == free.size()) break;
    free = inside;
  }
  return step;
}

}  // namespace

LeastSquaresFit fit_least_squares(const ResidualsAt& residuals, const Eigen::VectorXd& start,
                                  const LeastSquaresOptions& options) {
  return resume_least_squares(residuals, {start, options.difference, 0}, options);
}

LeastSquaresFit resume_least_squares(const ResidualsAt& residuals, const LeastSquaresState& from,
                                     const LeastSquaresOptions& options) {
  const Eigen::VectorXd& start = from.point;
  Best best{start, residuals({start}).front(), 0.0};
  best.cost = best.residual.squaredNorm();
  double difference = from.difference;
  int round = from.rounds;
  while (round < options.most_rounds && difference >= options.least_difference) {
    const Best at = best;
    std::vector<Eigen::VectorXd> neighbours;
    for (Eigen::Index i = 0; i < start.size(); ++i) {
      // To alternate sides, where both are in the cube, looks both ways in two rounds.
      const bool back =
          at.point(i) + difference > 1.0 || (round % 2 == 1 && at.point(i) - difference >= 0.0);
      neighbours.push_back(at.point);
      neighbours.back()(i) += back ? -difference : difference;
    }
    const std::vector<Eigen::VectorXd> near = residuals(neighbours);
    Eigen::MatrixXd jacobian(at.residual.size(), start.size());
    for (Eigen::Index i = 0; i < start.size(); ++i) {
      jacobian.col(i) = (near[i] - at.residual) / (neighbours[i](i) - at.point(i));
    }
    std::vector<Eigen::VectorXd> candidates;
    for (const double damping : kDamping) {
      Eigen::VectorXd step = damped_step(jacobian, at.residual, at.point, damping);
      const double longest = step.cwiseAbs().maxCoeff();
      if (longest > options.most_step) step *= options.most_step / longest;
      candidates.push_back((at.point + step).cwiseMax(0.0).cwiseMin(1.0));
    }
    const bool by_step = best.improve(candidates, residuals(candidates));
    const bool by_neighbour = best.improve(neighbours, near);
    if (!by_step && !by_neighbour) difference *= kShrink;
    ++round;
    if (options.keep) options.keep({best.point, difference, round});
    if (options.progress && !options.progress(round, best.cost)) break;
  }
  return {best.point, best.cost, round};
}

}  // namespace coapt
