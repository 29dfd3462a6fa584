// What a fit leaves unknown.
#pragma once

#include <Eigen/Core>

#include "search/fit/fit_problem.h"

namespace coapt {

struct FitPosterior {
  Eigen::MatrixXd covariance;  ///< of the values
  double leak_sd_mm2 = 0.0;    ///< that they leave the leak
};

/// Linearised about `point`, by differences of half a prior standard deviation to either side.
FitPosterior posterior_at(FitProblem& problem, const Eigen::VectorXd& point,
                          const FitWeights& weights);

}  // namespace coapt
