// The same point of the leaflets on two meshes of one valve.
#pragma once

#include "core/valve/leaflet_coordinates.h"
#include "core/valve/valve.h"

namespace coapt {

struct ClosedMesh {
  Valve valve;
  LeafletCoordinates coordinates;  ///< of `valve`
  Points closed_mm;                ///< |V| x 3
};

/// Where `other` has each vertex of `valve`, by leaflet coordinates.  |V of valve| x 3
Points matching_points_mm(const Valve& valve, const ClosedMesh& other);

}  // namespace coapt
