// The smallest valve that is one: an open cone of 8 x 2 quads, two papillary heads, two chordae.
#pragma once

#include "core/valve/valve.h"

namespace coapt {

/// 24 vertices in three rings of 8 from the annulus (0 to 7) to the free edge (16 to 23), each ring
/// counter-clockwise from +x; 32 faces, 4 a column. The annulus is an ellipse of 36 x 28 mm in z =
/// 0, under pressure where it is at rest. Chorda 0 branches (AL1 to the free edge at vertices 20
/// and 21), chorda 1 is one segment (PM1 to vertex 18). Rest lengths are the distances in the rest
/// shape; chordae pull at vertices, and nothing resists bending.
Valve small_valve();

/// The same with leaflets so tall, at rest, that the true size of a ring is that of its annulus: 36 mm.
Valve fitting_valve();

}  // namespace coapt
