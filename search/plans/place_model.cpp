#include "search/plans/place_model.h"

#include <cmath>
#include <limits>
#include <utility>

namespace coapt {
namespace {

// In units of a place; as shares of the variance.
constexpr double kLengths[] = {1.0, 2.0, 3.0, 5.0, 8.0}, kNoises[] = {1e-4, 1e-2, 1e-1};
constexpr double kPriorValues = 2.0;

}  // namespace

double PlaceModel::kernel(const Eigen::VectorXd& a, const Eigen::VectorXd& b) const {
  return std::exp(-0.5 * (a - b).squaredNorm() / (length_ * length_));
}

PlaceModel::PlaceModel(std::vector<Eigen::VectorXd> places, const Eigen::VectorXd& values,
                       double usual_sd)
    : places_(std::move(places)), mean_(values.mean()) {
  const Eigen::Index n = values.size();
  const Eigen::VectorXd off = values.array() - mean_;
  double likeliest = -std::numeric_limits<double>::infinity(), best_length = kLengths[0];
  for (const double length : kLengths) {
    length_ = length;
    Eigen::MatrixXd correlations(n, n);
    for (Eigen::Index i = 0; i < n; ++i)
      for (Eigen::Index j = 0; j <= i; ++j)
        correlations(i, j) = correlations(j, i) = kernel(places_[i], places_[j]);
    for (const double noise : kNoises) {
      Eigen::MatrixXd noisy = correlations;
      noisy.diagonal().array() += noise;
      const Eigen::LLT<Eigen::MatrixXd> factor(noisy);
      const Eigen::VectorXd weights = factor.solve(off);
      const double count = static_cast<double>(n) + kPriorValues;
      const double variance = (off.dot(weights) + kPriorValues * usual_sd * usual_sd) / count;
      const double likelihood =
          -0.5 * count * std::log(variance) - factor.matrixLLT().diagonal().array().log().sum();
      if (likelihood <= likeliest) continue;
      likeliest = likelihood;
      best_length = length;
      variance_ = variance;
      factor_ = factor;
      weights_ = weights;
    }
  }
  length_ = best_length;
}

PlaceModel::Guess PlaceModel::at(const Eigen::VectorXd& place) const {
  Eigen::VectorXd near(weights_.size());
  for (Eigen::Index i = 0; i < near.size(); ++i) near[i] = kernel(place, places_[i]);
  const double left = 1.0 - factor_.matrixL().solve(near).squaredNorm();
  return {mean_ + near.dot(weights_), std::sqrt(variance_ * std::max(0.0, left))};
}

}  // namespace coapt
