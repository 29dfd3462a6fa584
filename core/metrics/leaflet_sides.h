// The two sides that coapt: every face belongs to one, those of the commissures too.
#pragma once

#include <vector>

#include "core/metrics/surface_tree.h"
#include "core/valve/valve.h"

namespace coapt {

/// Order of Valve::faces. Faces of the commissures belong to the side of the line between the
/// commissures on which they lie at rest.
std::vector<Leaflet> leaflet_sides(const Valve& valve);

/// The faces of one side. @param sides leaflet_sides()
SurfaceTree surface_of(const Valve& valve, const Points& closed_mm,
                       const std::vector<Leaflet>& sides, Leaflet side);

}  // namespace coapt
