#include "core/closure/predicted_start.h"

#include <Eigen/Dense>
#include <algorithm>
#include <iterator>

#include "core/closure/crossing.h"

namespace coapt {
namespace {

// Of the square of the largest distance between a closure and the wanted one: what a closure at the
// very place counts as, so that no single one decides.
constexpr double kNearest = 0.05;
constexpr double kRankTolerance = 1e-9;

bool is_usable(const ClosureResult& closure, const ClosureResult& first) {
  if (!trusted(closure) || closure.closed_mm.rows() != first.closed_mm.rows() ||
      closure.branch_points_mm.size() != first.branch_points_mm.size())
    return false;
  for (std::size_t c = 0; c < closure.branch_points_mm.size(); ++c)
    if (closure.branch_points_mm[c].rows() != first.branch_points_mm[c].rows()) return false;
  return true;
}

std::vector<int> united(const std::vector<int>& a, const std::vector<int>& b) {
  std::vector<int> both;
  std::set_union(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(both));
  return both;
}

}  // namespace

std::optional<ClosureResult> predicted_start(const Faces& faces,
                                             std::span<const ClosureShare> shares) {
  if (shares.empty() || shares[0].closure == nullptr) return std::nullopt;
  const ClosureResult& first = *shares[0].closure;
  ClosureResult start;
  start.method = first.method;
  start.membrane = first.membrane;
  start.status = ClosureStatus::Converged;
  start.predicted = true;
  start.closed_mm = Points::Zero(first.closed_mm.rows(), 3);
  for (const Points& ends : first.branch_points_mm)
    start.branch_points_mm.push_back(Points::Zero(ends.rows(), 3));
  for (const auto& [closure, share] : shares) {
    if (closure == nullptr || !is_usable(*closure, first)) return std::nullopt;
    start.closed_mm += share * closure->closed_mm;
    for (std::size_t c = 0; c < start.branch_points_mm.size(); ++c)
      start.branch_points_mm[c] += share * closure->branch_points_mm[c];
    start.guarded_faces = united(start.guarded_faces, closure->guarded_faces);
  }
  if (!crossing_pairs(faces, start.closed_mm).empty()) return std::nullopt;
  return start;
}

std::vector<double> linear_shares(std::span<const Eigen::VectorXd> parameters,
                                  const Eigen::VectorXd& wanted) {
  const auto others = static_cast<Index>(parameters.size()) - 1;
  std::vector<double> shares(parameters.size(), 0.0);
  shares[0] = 1.0;
  if (others == 0) return shares;
  Eigen::VectorXd far(others);  // squares of distances
  for (Index j = 0; j < others; ++j) far[j] = (parameters[j + 1] - wanted).squaredNorm();
  far.array() += kNearest * far.maxCoeff() + 1e-12;
  Eigen::MatrixXd scaled(wanted.size(), others);
  for (Index j = 0; j < others; ++j)
    scaled.col(j) = (parameters[j + 1] - parameters[0]) / std::sqrt(far[j]);
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> fit;
  fit.setThreshold(kRankTolerance);
  fit.compute(scaled);
  const Eigen::VectorXd solution = fit.solve(wanted - parameters[0]);
  for (Index j = 0; j < others; ++j) {
    shares[j + 1] = solution[j] / std::sqrt(far[j]);
    shares[0] -= shares[j + 1];
  }
  return shares;
}

}  // namespace coapt
