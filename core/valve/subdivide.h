// Each triangle cut into four at the midpoints of its edges.
#pragma once

#include <array>
#include <vector>

#include "core/valve/valve.h"

namespace coapt {

/// New vertices follow the old ones, which keep their indices: edge i's is vertex `vertices` + i.
/// Face f becomes faces 4f to 4f + 2, which keep its corners 0 to 2 as their own first, second and
/// third corner, and 4f + 3 in the middle, whose corner k lies opposite to corner k of f. All are
/// wound as f.
struct Subdivision {
  int vertices = 0;  ///< of the mesh before
  Faces faces;       ///< 4 |F| x 3
  /// Ends of each edge, the smaller index first; in the order in which the faces name them.
  std::vector<std::array<int, 2>> edges;
};

/// @param vertices |V|; every index in `faces` is smaller.
Subdivision subdivide(const Faces& faces, int vertices);

/// |V| x 3 -> (|V| + |E|) x 3, the new points halfway between the ends of their edges.
Points with_midpoints(const Points& points, const Subdivision& subdivision);

/// The same point of the same flat face, in one of the four that it became; weights add up to 1.
/// What else an insertion holds is kept.
Insertion subdivided(Insertion insertion);

}  // namespace coapt
