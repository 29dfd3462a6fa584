#include "io/mesh/ring_solid.h"

#include <cmath>
#include <numbers>
#include <vector>

#include "core/valve/contour.h"

namespace coapt {
namespace {

constexpr int kStations = 240;    // along the contour: 0.4 mm apart
constexpr int kCoreCorners = 22;  // round the core

}  // namespace

Eigen::Matrix<double, Eigen::Dynamic, 2> section_corners_mm(const RingSection& section) {
  const double radius = section.core_radius_mm, half = 0.5 * section.band_thickness_mm;
  const double first = std::asin(half / radius);  // where the band's upper side leaves the core
  Eigen::Matrix<double, Eigen::Dynamic, 2> corners(kCoreCorners + 2, 2);
  for (int k = 0; k < kCoreCorners; ++k) {
    const double angle =
        first + (2.0 * std::numbers::pi - 2.0 * first) * k / static_cast<double>(kCoreCorners - 1);
    corners.row(k) << radius * std::cos(angle), radius * std::sin(angle);
  }
  corners.row(kCoreCorners) << radius + section.band_width_mm, -half;
  corners.row(kCoreCorners + 1) << radius + section.band_width_mm, half;
  return corners;
}

TriangleMesh ring_solid(const Points& contour_mm, const RingSection& section) {
  const auto corners = section_corners_mm(section);
  const auto count = static_cast<int>(corners.rows());
  const ArcLength contour(contour_mm);
  TriangleMesh mesh;
  mesh.vertices_mm.resize(kStations * count, 3);
  mesh.faces.resize(2 * kStations * count, 3);
  int face = 0;
  for (int s = 0; s < kStations; ++s) {
    const double arc = contour.total_mm() * s / kStations;
    const Vec3 middle = contour.at(arc), along = contour.tangent(arc);
    const Vec3 outwards = along.cross(Vec3::UnitZ()).normalized();
    const Vec3 upwards = outwards.cross(along);
    const int next = (s + 1) % kStations;
    for (int k = 0; k < count; ++k) {
      mesh.vertices_mm.row(s * count + k) =
          middle + corners(k, 0) * outwards + corners(k, 1) * upwards;
      const int beside = (k + 1) % count;
      const int a = s * count + k, b = s * count + beside;
      const int c = next * count + k, d = next * count + beside;
      mesh.faces.row(face++) << a, b, c;
      mesh.faces.row(face++) << b, d, c;
    }
  }
  if (enclosed_mm3(mesh) < 0.0) mesh.faces.col(1).swap(mesh.faces.col(2));
  return mesh;
}

double enclosed_mm3(const TriangleMesh& mesh) {
  double six_times = 0.0;
  for (Index f = 0; f < mesh.faces.rows(); ++f) {
    const Vec3 a = mesh.vertices_mm.row(mesh.faces(f, 0)),
               b = mesh.vertices_mm.row(mesh.faces(f, 1));
    const Vec3 c = mesh.vertices_mm.row(mesh.faces(f, 2));
    six_times += a.dot(b.cross(c));
  }
  return six_times / 6.0;
}

}  // namespace coapt
