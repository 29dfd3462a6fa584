// Which voxels lie on the atrial side of the narrowest place: the least cut between them, by maximal flow (Dinic 1970).
//
// The first layer of the grid along z is the ventricle, the last the atrium, the outermost ones along x and y are walls. From voxel
// to voxel as much flows as their centres' clearance leaves free. Steps of a cut are counted along the axes, so that its
// area is up to half as large again as that of a smooth surface: it says where the narrowest place is, not how wide. Voxels farther
// than kOpen_mm from all tissue belong to the side from which they are reached, if no way through such voxels leads from one side to the
// other. Voxels that neither side reaches, because they are covered or cut off, fall to the side from which fewer covered steps lead
// there: so that sides meet where leaflets touch, too.
#pragma once

#include <vector>

#include "core/metrics/voxels.h"

namespace coapt {

struct AtrialSide {
  std::vector<char> is_atrial;  ///< of each voxel of the grid
  std::vector<std::array<int, 2>>
      cut;  ///< each pair of neighbours on different sides that no tissue parts: voxel, axis
};

AtrialSide atrial_side(const Partition& partition, const VoxelGrid& grid);

}  // namespace coapt
