#include "lab/closures/closure_library.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/closure/predicted_start.h"
#include "core/metrics/quantile.h"

namespace coapt {
namespace {

// Of the variance: closures are within hundredths of a millimetre of their ends, and places do not say all of a scene.
constexpr double kNugget = 1e-3;

/// Annulus and tips: both move the leaflets by as much as they move themselves.
Eigen::VectorXd place_of(const Valve& scene) {
  const Index vertices = scene.annulus_mm.rows();
  Eigen::VectorXd place(3 * (vertices + static_cast<Index>(scene.heads.size())));
  Index at = 0;
  const double share = 1.0 / std::sqrt(static_cast<double>(vertices));
  for (Index i = 0; i < vertices; ++i, at += 3)
    place.segment<3>(at) = share * scene.annulus_mm.row(i).transpose();
  for (const PapillaryHead& head : scene.heads) {
    place.segment<3>(at) = head.tip_mm / std::sqrt(static_cast<double>(scene.heads.size()));
    at += 3;
  }
  return place;
}

}  // namespace

ClosureLibrary::ClosureLibrary(const std::vector<Valve>& scenes,
                               std::vector<ClosureResult> closures) {
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    if (!trusted(closures[i])) continue;
    places_mm_.push_back(place_of(scenes[i]));
    closures_.push_back(std::move(closures[i]));
  }
  std::vector<double> apart = {1.0};
  for (std::size_t i = 0; i < places_mm_.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) apart.push_back((places_mm_[i] - places_mm_[j]).norm());
  range_mm_ = quantile(apart, 0.5);
  const auto count = static_cast<Index>(closures_.size());
  Eigen::MatrixXd bordered = Eigen::MatrixXd::Ones(count + 1, count + 1);
  bordered(count, count) = 0.0;
  for (Index i = 0; i < count; ++i)
    for (Index j = 0; j < count; ++j)
      bordered(i, j) =
          std::exp(-0.5 * ((places_mm_[i] - places_mm_[j]) / range_mm_).squaredNorm()) +
          (i == j ? kNugget : 0.0);
  inverse_ = bordered.fullPivLu().inverse();
}

ClosureLibrary::Start ClosureLibrary::start_of(const Valve& scene) const {
  if (closures_.empty()) return {};
  const auto count = static_cast<Index>(closures_.size());
  const Eigen::VectorXd place = place_of(scene);
  Eigen::VectorXd covariance = Eigen::VectorXd::Ones(count + 1);
  for (Index i = 0; i < count; ++i)
    covariance[i] = std::exp(-0.5 * ((places_mm_[i] - place) / range_mm_).squaredNorm());
  const Eigen::VectorXd shares = inverse_ * covariance;
  std::vector<ClosureShare> parts;
  for (Index i = 0; i < count; ++i) parts.push_back({&closures_[i], shares[i]});
  if (std::optional<ClosureResult> mean = predicted_start(scene.faces, parts))
    return {std::move(mean), false};
  const auto nearest =
      std::min_element(places_mm_.begin(), places_mm_.end(), [&](const auto& a, const auto& b) {
        return (a - place).squaredNorm() < (b - place).squaredNorm();
      });
  return {closures_[nearest - places_mm_.begin()], true};
}

}  // namespace coapt
