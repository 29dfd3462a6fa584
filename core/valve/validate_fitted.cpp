#include <Eigen/Eigenvalues>
#include <set>

#include "core/valve/validate_parts.h"

namespace coapt {
namespace {

constexpr Index kMostParameters = 64;
constexpr double kMostVariance = 100.0;
constexpr double kSlight =
    1e-9;  // of the largest variance: what rounding may make of a symmetric matrix

}  // namespace

void check_fitted(const Valve& valve, ProblemList& problems) {
  if (!valve.fitted) return;
  const auto& [names, covariance] = *valve.fitted;
  const Index count = std::ssize(names);
  if (count < 1 || count > kMostParameters)
    problems.add(ErrorCode::OutOfRange, "/fit/parameters", "must hold 1 to 64 names");
  if (std::set<std::string>(names.begin(), names.end()).size() != names.size())
    problems.add(ErrorCode::OutOfRange, "/fit/parameters", "must hold each name once");
  if (covariance.rows() != count || covariance.cols() != count) {
    problems.add(
        ErrorCode::BadGeometry, "/fit/covariance",
        "must have a row and a column for each of the " + std::to_string(count) + " parameters");
    return;
  }
  if (!(covariance.array().abs() <= kMostVariance).all()) {
    problems.add(ErrorCode::OutOfRange, "/fit/covariance", "must hold numbers from -100 to 100");
    return;
  }
  const double slight = kSlight * covariance.cwiseAbs().maxCoeff();
  if ((covariance - covariance.transpose()).cwiseAbs().maxCoeff() > slight ||
      Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(covariance).eigenvalues()(0) < -slight)
    problems.add(ErrorCode::BadGeometry, "/fit/covariance",
                 "must be symmetric and positive semidefinite");
}

}  // namespace coapt
