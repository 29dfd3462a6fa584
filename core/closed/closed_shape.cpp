#include "core/closed/closed_shape.h"

#include "core/metrics/leaflet_sides.h"

namespace coapt {

LeafletMesh shape_of(const ClosedValve& closed) {
  LeafletMesh mesh{closed.closure.closed_mm,
                   closed.valve.faces,
                   {to_string(Leaflet::Anterior), to_string(Leaflet::Posterior)},
                   {}};
  for (const Leaflet side : leaflet_sides(closed.valve))
    mesh.leaflets.push_back(static_cast<int>(side));
  return without_loose_vertices(mesh);
}

}  // namespace coapt
