#include "lab/closures/matching_points.h"

#include "core/valve/leaflet_point.h"

namespace coapt {

Points matching_points_mm(const Valve& valve, const ClosedMesh& other) {
  const LeafletCoordinates coordinates = leaflet_coordinates(valve);
  Points points = Points::Zero(valve.rest_mm.rows(), 3);
  for (Eigen::Index f = 0; f < valve.faces.rows(); ++f)
    for (std::size_t k = 0; k < 3; ++k) {
      Insertion corner{static_cast<int>(f), {0.0, 0.0, 0.0}};
      corner.weights[k] = 1.0;
      const LeafletPoint point = leaflet_point(valve, coordinates, corner);
      const Insertion there = locate(other.valve, other.coordinates, point);
      points.row(valve.faces(f, static_cast<Eigen::Index>(k))) =
          position(there, other.valve.faces, other.closed_mm);
    }
  return points;
}

}  // namespace coapt
