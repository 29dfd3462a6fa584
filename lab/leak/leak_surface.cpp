#include "lab/leak/leak_surface.h"

#include <set>

namespace coapt {

LeakSurface leak_surface(const Valve& valve, const Points& shape_mm) {
  return {shape_mm, valve.faces, valve.annulus, 0.5 * valve.tissue.thickness_mm};
}

std::vector<std::array<int, 2>> free_edges(const LeakSurface& surface) {
  std::set<std::array<int, 2>> sides;
  for (Index f = 0; f < surface.faces.rows(); ++f)
    for (int corner = 0; corner < 3; ++corner)
      sides.insert({surface.faces(f, corner), surface.faces(f, (corner + 1) % 3)});
  const std::set<int> annulus(surface.annulus.begin(), surface.annulus.end());
  std::vector<std::array<int, 2>> edges;
  for (const auto& [from, to] : sides)
    if (!sides.contains({to, from}) && !(annulus.contains(from) && annulus.contains(to)))
      edges.push_back({from, to});
  return edges;
}

LeakSurface with_skirt(LeakSurface surface, double reach_mm) {
  const Index first = surface.points_mm.rows(), loop = std::ssize(surface.annulus);
  const Points annulus_mm = surface.points_mm(surface.annulus, Eigen::all);
  const Eigen::RowVector3d middle_mm = annulus_mm.colwise().mean();
  surface.points_mm.conservativeResize(first + loop, Eigen::NoChange);
  Index face = surface.faces.rows();
  surface.faces.conservativeResize(face + 2 * loop, Eigen::NoChange);
  for (Index i = 0; i < loop; ++i) {
    Eigen::RowVector3d outwards = annulus_mm.row(i) - middle_mm;
    outwards.z() = 0.0;
    surface.points_mm.row(first + i) = annulus_mm.row(i) + reach_mm * outwards.normalized();
    const Index next = (i + 1) % loop;
    const int near = surface.annulus[static_cast<std::size_t>(i)];
    const int near_next = surface.annulus[static_cast<std::size_t>(next)];
    surface.faces.row(face++) << near, static_cast<int>(first + i), near_next;
    surface.faces.row(face++) << near_next, static_cast<int>(first + i),
        static_cast<int>(first + next);
  }
  return surface;
}

}  // namespace coapt
