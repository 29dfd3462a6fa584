// An import whose answer is known: a cone from a circle of radius 18 mm at z = 0 to one of 12 mm at
// z = -15.
#pragma once

#include "io/mesh/import_valve.h"

namespace coapt {

inline constexpr double kTop_mm = 18.0, kBottom_mm = 12.0, kDepth_mm = 15.0;

/// Part of the cone between two angles, in facets of one degree by 1.5 mm; `from` 0 and `to` 360
/// closes it.
TriangleMesh cone(int from_deg, int to_deg);

/// The point of the cone at an angle and a share of the way down.
Vec3 on_cone(double angle_deg, double share);

/// One skirt in the valve's frame, tips at (-+10, 0, -25), a chorda from each to the free edge
/// below it.
ImportSource cone_source();

/// The same as two sheets, with a gap of 20 degrees at both commissures (0 and 180 degrees).
ImportSource cone_source_with_gaps();

}  // namespace coapt
