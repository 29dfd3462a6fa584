// The voxels of 0.5 mm about a cut among voxels of 1 mm, eight to a coarse one, and the least surface among them.
//
// The band reaches 1.5 mm from the coarse cut; where the least surface reaches its border it is widened there, and the surface is
// looked for again. Voxels of the border are fixed to the side on which they lie. A fine voxel has its coarse one's side if no tissue
// passes within the coarse one, else that of a neighbour from which nothing parts it.
#pragma once

#include <vector>

#include "core/metrics/atrial_side.h"
#include "core/metrics/least_surface.h"

namespace coapt {

struct CutBand {
  VoxelGrid grid;
  std::vector<BandVoxel> voxels;
  std::vector<int>
      places;  ///< of the grid's voxels: where they are among `voxels`, -1 if they are not
  LeastSurface surface;  ///< of `voxels`
};

CutBand cut_band(const Partition& partition, const VoxelGrid& coarse, const AtrialSide& side);

}  // namespace coapt
