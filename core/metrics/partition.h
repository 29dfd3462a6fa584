// What parts atrium from ventricle, as triangles: the leaflets and a strip of tissue about the annulus, and a wall beyond.
#pragma once

#include <array>
#include <vector>

#include "core/valve/valve.h"

namespace coapt {

using Corners = std::array<Vec3, 3>;  ///< of a triangle, mm

struct Partition {
  std::vector<Corners> leaflets;  ///< mid-surfaces, and the strip about the annulus
  /// Of each of them, the one beyond its edge from corner k to the next; -1: none.
  std::vector<std::array<int, 3>> beyond;
  std::vector<char> touches_rim;  ///< of each of them: has a corner where the leaflets end
  std::vector<Corners> walls;     ///< without thickness
  double half_thickness_mm = 0.0;
};

/// The strip and the wall run outwards from the annulus, along its plane.
/// @param points_mm |V| x 3, finite, in the annulus's axes (into_frame())
Partition partition_of(const Valve& valve, const Points& points_mm);

}  // namespace coapt
