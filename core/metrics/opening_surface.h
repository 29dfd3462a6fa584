// The least surface of an opening as triangles, for pictures: where u passes 1/2, a quadrangle for each square of voxels that is free,
// its corners moved along the surface's normal to where u passes (surface nets, Gibson 1998), its rim smoothed.
//
// Where the tissue covers a part of a square the quadrangle runs on into it, by less than a voxel.
#pragma once

#include <vector>

#include "core/metrics/cut_band.h"

namespace coapt {

struct OpeningSurface {
  Points points_mm = Points(0, 3);
  Faces faces = Faces(0, 3);  ///< seen from the atrium counter-clockwise
  std::vector<int> outline;   ///< vertices around its longest rim, closed
};

/// In the band's axes.
/// @param opening places of its voxels in `band.voxels`
OpeningSurface opening_surface(const CutBand& band, const std::vector<int>& opening);

}  // namespace coapt
