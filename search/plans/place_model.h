// What a figure of a plan is expected to be, from plans that put the valve in a similar place (PlanRecord::place): a Gaussian process with a
// constant mean (Rasmussen and Williams 2006, 2.7), its length and noise those of a small table that make what was measured likeliest (5.4.1).
#pragma once

#include <Eigen/Cholesky>
#include <vector>

namespace coapt {

class PlaceModel {
 public:
  struct Guess {
    double mean = 0.0, sd = 0.0;
  };

  /// @param usual_sd what values differ by, as far as is known without them: it counts as much as two of them.
  /// @pre as many places as values, at least one; places of one length.
  PlaceModel(std::vector<Eigen::VectorXd> places, const Eigen::VectorXd& values, double usual_sd);

  Guess at(const Eigen::VectorXd& place) const;

 private:
  double kernel(const Eigen::VectorXd& a, const Eigen::VectorXd& b) const;

  std::vector<Eigen::VectorXd> places_;
  double mean_ = 0.0, variance_ = 0.0, length_ = 1.0;
  Eigen::LLT<Eigen::MatrixXd> factor_;  // of the correlations, noise on their diagonal
  Eigen::VectorXd weights_;
};

}  // namespace coapt
