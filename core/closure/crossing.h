// Whether leaflet triangles pass through each other: the test that an orifice of zero cannot
// replace.
//
// Two triangles cross if an edge of one pierces the other. Triangles that share an edge cannot
// cross without folding flat; triangles that share a vertex cross if the edge opposite to it
// pierces.
#pragma once

#include <utility>
#include <vector>

#include "core/valve/types.h"

namespace coapt {

/// Whether an edge of face f that has no vertex in face g pierces g.
bool edge_pierces(const Faces& faces, const Points& x, int f, int g);

/// Pairs (f < g) of faces that pass through each other, in ascending order: all boxes that meet are
/// tested.
std::vector<std::pair<int, int>> crossing_pairs(const Faces& faces, const Points& x);

}  // namespace coapt
