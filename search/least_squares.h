// Nonlinear least squares in the unit cube: Levenberg (1944) and Marquardt (1963) with differences
// for the derivatives, for residuals that are dear, a little noisy, and can be had side by side.
//
// Each round evaluates one neighbour along every axis at once, then one step for each of a ladder
// of damping values at once, and takes the best point of all; where none is better, the differences
// shrink. Bounds: an axis that would leave the cube stays at its face for the round (active set).
#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

namespace coapt {

/// Residuals at several points of [0, 1]^n; each of the same length, finite. Called with up to
/// max(n, 8) points.
using ResidualsAt =
    std::function<std::vector<Eigen::VectorXd>(const std::vector<Eigen::VectorXd>&)>;

/// Between two rounds: from here a run goes on as it would have without a break.
struct LeastSquaresState {
  Eigen::VectorXd point;    ///< the best so far
  double difference = 0.0;  ///< of the next round
  int rounds = 0;           ///< done
};

struct LeastSquaresOptions {
  double difference = 0.06;        ///< first, of the axes' unit length; above the noise
  double least_difference = 0.01;  ///< it ends when differences get shorter
  double most_step = 0.3;          ///< along any axis
  int most_rounds = 30;
  /// Rounds done, cost (sum of squares); false stops.
  std::function<bool(int, double)> progress;
  std::function<void(const LeastSquaresState&)>
      keep;  ///< called after each round, before `progress`
};

struct LeastSquaresFit {
  Eigen::VectorXd point;
  double cost = 0.0;
  int rounds = 0;
};

/// @param start in the cube.
LeastSquaresFit fit_least_squares(const ResidualsAt& residuals, const Eigen::VectorXd& start,
                                  const LeastSquaresOptions& options = {});

/// A run that was broken off after `from`.
LeastSquaresFit resume_least_squares(const ResidualsAt& residuals, const LeastSquaresState& from,
                                     const LeastSquaresOptions& options = {});

}  // namespace coapt
