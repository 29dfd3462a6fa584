// The least area of a surface that parts atrium from ventricle within a band of voxels, as a continuous minimal cut (Strang 1983,
// Math Program 26:123): of all u in [0, 1] between the ventricle's 0 and the atrium's 1 the least sum of |share grad u|, share being
// what is free of the square between two voxels. Found by the primal-dual iteration of Chambolle and Pock (2011, J Math Imaging
// Vis 40:120), whose dual is a lower bound at every step: the problem is convex, so that there is one area, however it is reached.
#pragma once

#include <vector>

#include "core/metrics/voxels.h"

namespace coapt {

/// A voxel in the band or on its border.
struct BandVoxel {
  int voxel = 0;                       ///< of the grid
  bool is_fixed = false;               ///< u stays as it is: on the border
  float u = 0.0f;                      ///< at the start
  std::array<std::uint8_t, 3> free{};  ///< points of the squares to the next voxels
};

struct LeastSurface {
  double upper_mm2 = 0.0;  ///< area of the cut that was found
  double lower_mm2 = 0.0;  ///< no cut within the band is smaller
  std::vector<float> u;    ///< of each voxel
  std::vector<Vec3>
      parts_mm2;  ///< of each voxel: its part of the area, along the normal towards the atrium
};

/// @param band by ascending number of voxel, none of them in the grid's first or last layer along an axis. Squares to voxels that
/// are not among them are walls.
LeastSurface least_surface(const VoxelGrid& grid, const std::vector<BandVoxel>& band);

}  // namespace coapt
