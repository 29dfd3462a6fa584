// How much of each face between two voxels is free of tissue: what a cut through it costs.
//
// A face is asked at 16 points, evenly spaced, whether the surface is nearer than half its thickness (exact distances to triangles);
// so an opening narrower than a voxel counts by its width, and a sheet as thick as two voxels has no hole.
#pragma once

#include <vector>

#include "lab/leak/leak_surface.h"
#include "lab/leak/voxel_band.h"

namespace coapt {

/// Of each cell of a band, by its index, and cells + 2 or more long: its values towards the next cell along x, y and z.
using AxisFields = std::array<std::vector<float>, 3>;

/// Shares in [0, 1]; 0 where the next cell is not in the band, or is fixed as the cell itself is.
AxisFields free_shares(const VoxelBand& band, const LeakSurface& surface);

}  // namespace coapt
