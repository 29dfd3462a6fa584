#include "search/fit/measured_surface.h"

#include <array>
#include <cmath>
#include <set>

#include "core/metrics/surface_tree.h"

namespace coapt {
namespace {

std::vector<Eigen::Index> first_of_cubes(const Points& points_mm, double edge_mm) {
  std::set<std::array<long, 3>> taken;
  std::vector<Eigen::Index> first;
  for (Eigen::Index i = 0; i < points_mm.rows(); ++i) {
    std::array<long, 3> cube{};
    for (std::size_t k = 0; k < 3; ++k)
      cube[k] = std::lround(std::floor(points_mm(i, static_cast<Eigen::Index>(k)) / edge_mm));
    if (taken.insert(cube).second) first.push_back(i);
  }
  return first;
}

}  // namespace

Points thinned(const Points& points_mm, int most) {
  constexpr double kFirstEdge_mm = 0.25, kGrowth = 1.2;
  if (points_mm.rows() <= most) return points_mm;
  double edge_mm = kFirstEdge_mm;
  std::vector<Eigen::Index> kept = first_of_cubes(points_mm, edge_mm);
  while (std::ssize(kept) > most) kept = first_of_cubes(points_mm, edge_mm *= kGrowth);
  return points_mm(kept, Eigen::all);
}

ClosedSurface surface_of(const ClosedValve& closed) {
  ClosedSurface surface{closed.closure.closed_mm, closed.valve.faces, {}};
  for (int face = 0; face < static_cast<int>(surface.faces.rows()); ++face)
    surface.thickness_mm.push_back(thickness_mm(closed.valve, face));
  return surface;
}

std::vector<double> signed_distances_mm(const Points& points_mm, const ClosedSurface& model,
                                        MeasuredSide side) {
  const SurfaceTree tree(model.closed_mm, model.faces);
  const SurfaceEdge edge(model.faces);
  std::vector<double> distances;
  distances.reserve(static_cast<std::size_t>(points_mm.rows()));
  for (Eigen::Index i = 0; i < points_mm.rows(); ++i) {
    const Vec3 point = points_mm.row(i);
    const TreePoint nearest = tree.nearest(point);
    const auto corner = [&](int k) {
      return Vec3(model.closed_mm.row(model.faces(nearest.face, k)));
    };
    const Vec3 normal = (corner(1) - corner(0)).cross(corner(2) - corner(0));
    const bool below = normal.dot(point - nearest.point_mm) < 0.0 && !edge.holds(nearest);
    const double above_mm = side == MeasuredSide::Atrial
                                ? 0.5 * model.thickness_mm[static_cast<std::size_t>(nearest.face)]
                                : 0.0;
    distances.push_back((below ? -1.0 : 1.0) * nearest.distance_mm - above_mm);
  }
  return distances;
}

}  // namespace coapt
