#include "core/repair/leaflet_cut.h"

#include <algorithm>
#include <cmath>

namespace coapt {
namespace {

constexpr double kMeasured = 0.1;  // of `along`, on either side of the cut's middle
constexpr int kMeasuredPieces = 8;

template <class PointAt>
double length_mm(const PointAt& point_at) {
  double sum = 0.0;
  Vec3 last = point_at(0.0);
  for (int i = 1; i <= kMeasuredPieces; ++i) {
    const Vec3 next = point_at(static_cast<double>(i) / kMeasuredPieces);
    sum += (next - last).norm();
    last = next;
  }
  return sum;
}

}  // namespace

LeafletCut::LeafletCut(const LeafletResection& step, const LeafletCoordinates& coordinates,
                       const Valve& valve)
    : step_(step) {
  for (int row = 0; row <= kRows; ++row)
    row_mm_[row] =
        length_mm([&](double t) {
          return rest_position_mm(valve, coordinates,
                                  {step.leaflet, step.along + (2.0 * t - 1.0) * kMeasured,
                                   static_cast<double>(row) / kRows});
        }) /
        (2.0 * kMeasured);
  height_mm_ = length_mm([&](double t) {
    return rest_position_mm(valve, coordinates, {step.leaflet, step.along, t});
  });
}

double LeafletCut::row_mm(double height) const {
  const double at = std::clamp(height, 0.0, 1.0) * kRows;
  const int row = std::min(kRows - 1, static_cast<int>(at));
  return row_mm_[row] + (at - row) * (row_mm_[row + 1] - row_mm_[row]);
}

double LeafletCut::width_mm(double height) const {
  switch (step_.shape) {
    case ResectionShape::Quadrangular:
      return step_.width_mm;
    case ResectionShape::Triangular:
      break;
  }
  return step_.width_mm * std::max(0.0, 1.0 - (1.0 - height) / step_.height);
}

double LeafletCut::tissue_at(double along, double height, int side) const {
  const double half = 0.5 * width_along(height), middle = step_.along;
  if (side < 0) return along * (1.0 - half / middle);
  return 1.0 - (1.0 - along) * (1.0 - half / (1.0 - middle));
}

double LeafletCut::place_of(double tissue_along, double height) const {
  const double half = 0.5 * width_along(height), middle = step_.along;
  if (tissue_along <= middle) return std::min(middle, tissue_along / (1.0 - half / middle));
  return std::max(middle, 1.0 - (1.0 - tissue_along) / (1.0 - half / (1.0 - middle)));
}

bool LeafletCut::takes(double tissue_along, double height) const {
  return std::abs(tissue_along - step_.along) < 0.5 * width_along(height);
}

double LeafletCut::across_seam(const std::array<double, 2>& from,
                               const std::array<double, 2>& to) const {
  const auto flat = [&](double along, double height) {
    return Vec2((along - step_.along) * row_mm(height), height * height_mm_);
  };
  const double before = (flat(to[0], to[1]) - flat(from[0], from[1])).norm();
  Vec2 a = flat(tissue_at(from[0], from[1], -1), from[1]);
  Vec2 b = flat(tissue_at(to[0], to[1], 1), to[1]);
  const double from_width = width_mm(from[1]), to_width = width_mm(to[1]);
  if (step_.shape == ResectionShape::Triangular && from_width > 0.0 && to_width > 0.0) {
    // Both sides turn about the wedge's tip until the edges of the cut are one.
    const Vec2 tip(0.0, (1.0 - step_.height) * height_mm_);
    const double half = std::atan2(0.5 * step_.width_mm, step_.height * height_mm_);
    a = Eigen::Rotation2Dd(-half) * (a - tip);
    b = Eigen::Rotation2Dd(half) * (b - tip);
  } else {
    a.x() += 0.5 * from_width;
    b.x() -= 0.5 * to_width;
  }
  return (b - a).norm() / before;
}

}  // namespace coapt
