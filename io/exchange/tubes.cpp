#include "io/exchange/tubes.h"

#include <cmath>
#include <numbers>

namespace coapt {
namespace {

Vec3 direction(const TubeAxis& axis) {
  const Vec3 along = axis.end_mm - axis.start_mm;
  return along.norm() > 1e-9 ? Vec3(along.normalized()) : Vec3::UnitZ();
}

/// The coordinate axis that is furthest from being parallel.
Vec3 reference(const Vec3& along) {
  Eigen::Index axis = 0;
  along.cwiseAbs().minCoeff(&axis);
  return Vec3::Unit(axis);
}

}  // namespace

Tubes make_tubes(const std::vector<TubeAxis>& axes, const std::vector<TubeAxis>& shape_of) {
  const auto pieces = std::ssize(axes);
  Tubes tubes{Points(2 * kTubeSides * pieces, 3), Points(2 * kTubeSides * pieces, 3),
              Faces(2 * kTubeSides * pieces, 3)};
  for (std::size_t i = 0; i < axes.size(); ++i) {
    const Vec3 along = direction(axes[i]);
    Vec3 side = reference(direction(shape_of[i]));
    side -= side.dot(along) * along;
    side = side.norm() > 1e-3 ? Vec3(side.normalized()) : along.unitOrthogonal();
    const Vec3 other = along.cross(side);
    const int first = 2 * kTubeSides * static_cast<int>(i);
    for (int k = 0; k < kTubeSides; ++k) {
      const double angle = 2.0 * std::numbers::pi * k / kTubeSides;
      const Vec3 normal = std::cos(angle) * side + std::sin(angle) * other;
      for (const int end : {0, 1}) {
        const int vertex = first + end * kTubeSides + k;
        tubes.vertices_mm.row(vertex) =
            (end == 0 ? axes[i].start_mm : axes[i].end_mm) + axes[i].radius_mm * normal;
        tubes.normals.row(vertex) = normal;
      }
      const int a = first + k, b = first + (k + 1) % kTubeSides;
      tubes.faces.row(first + 2 * k) << a, b, b + kTubeSides;
      tubes.faces.row(first + 2 * k + 1) << a, b + kTubeSides, a + kTubeSides;
    }
  }
  return tubes;
}

}  // namespace coapt
