#include "core/metrics/leaflet_sides.h"

#include "core/metrics/annulus.h"
#include "core/valve/leaflet_of.h"

namespace coapt {

std::vector<Leaflet> leaflet_sides(const Valve& valve) {
  const Vec3 from = valve.rest_mm.row(valve.landmarks.anterolateral_commissure).transpose();
  const Vec3 to = valve.rest_mm.row(valve.landmarks.posteromedial_commissure).transpose();
  const Vec3 anterior = annulus_frame(valve, AnnulusAxis::Commissures).normal.cross(to - from);
  std::vector<Leaflet> sides;
  sides.reserve(valve.segments.size());
  for (std::size_t f = 0; f < valve.segments.size(); ++f) {
    if (const std::optional<Leaflet> leaflet = leaflet_of(valve.segments[f])) {
      sides.push_back(*leaflet);
      continue;
    }
    Vec3 centre = Vec3::Zero();
    for (int k = 0; k < 3; ++k) centre += valve.rest_mm.row(valve.faces(f, k)).transpose() / 3.0;
    sides.push_back((centre - from).dot(anterior) > 0.0 ? Leaflet::Anterior : Leaflet::Posterior);
  }
  return sides;
}

SurfaceTree surface_of(const Valve& valve, const Points& closed_mm,
                       const std::vector<Leaflet>& sides, Leaflet side) {
  std::vector<Index> own;
  for (Index f = 0; f < valve.faces.rows(); ++f)
    if (sides[static_cast<std::size_t>(f)] == side) own.push_back(f);
  return {closed_mm, valve.faces(own, Eigen::all)};
}

}  // namespace coapt
