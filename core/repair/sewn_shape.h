// The shape of a sheet whose triangles got other sides: where tissue was cut out and the edges of the
// cut were sewn together.
//
// In small steps, because a sheet bends easily and hardly stretches. Each is one of Gauss and Newton's:
// least squares of the edges' lengths against what they are to be, in mm, and of how much each vertex
// moves otherwise than its neighbours do on average, which picks the smooth one of the many ways that
// a sheet can bend; the same is asked, more weakly, of all steps together. First the lengths go to what they are to be in equal steps, then they settle.
#pragma once

#include <array>
#include <vector>

#include "core/valve/types.h"

namespace coapt {

struct EdgeLength {
  std::array<int, 2> vertices = {0, 0};
  double length_mm = 0.0;
};

/// @param start_mm |V| x 3 @param edges of the mesh, each once; those between two vertices that are
/// not free do not count @param free |V|
Points sewn_shape(const Points& start_mm, const std::vector<EdgeLength>& edges,
                  const std::vector<bool>& free);

}  // namespace coapt
