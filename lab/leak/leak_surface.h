// What a leak is measured of, as any program may give it: leaflets as a surface, and the loop that they hang from.
#pragma once

#include <vector>

#include "core/valve/valve.h"

namespace coapt {

/// In the valve's frame (core/valve/valve.h), z to the atrium.
struct LeakSurface {
  Points points_mm;          ///< |V| x 3, mid-surface of the leaflets
  Faces faces;               ///< |F| x 3
  std::vector<int> annulus;  ///< |A| vertices, a boundary loop
  double half_thickness_mm = 0.5;
};

/// @param shape_mm |V| x 3: the valve closed, or open
LeakSurface leak_surface(const Valve& valve, const Points& shape_mm);

/// The boundary besides the annulus, each edge as its face has it.
std::vector<std::array<int, 2>> free_edges(const LeakSurface& surface);

/// Faces from the annulus outwards in its plane, `reach_mm` wide: with them the surface parts all space around it. Vertices are
/// appended.
LeakSurface with_skirt(LeakSurface surface, double reach_mm);

}  // namespace coapt
