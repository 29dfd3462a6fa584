// A cut through leaflet sheets by a half-plane that ends in the annulus axis (z).
#pragma once

#include <vector>

#include "io/mesh/mesh_file.h"

namespace coapt {

/// Points (distance from the axis, z) from the annulus to the free edge.
struct LeafletCut {
  std::vector<Eigen::Vector2d>
      line_mm;                    ///< the first lies on the annulus; empty if no sheet begins there
  int sheet = -1;                 ///< the one that begins at the annulus
  double widest_bridge_mm = 0.0;  ///< across holes and bites of the sheets
  double length_mm() const;
};

/// Cuts through the annulus point. Where a sheet ends and goes on within `bridge_mm`, holes between
/// chordae for instance, the line goes straight across.
/// @param reach_mm furthest from the annulus that a sheet may begin.
struct CutOptions {
  double reach_mm = 3.0;
  double bridge_mm = 2.5;
};
LeafletCut cut_leaflets(const std::vector<TriangleMesh>& sheets, const Vec3& annulus_mm,
                        const CutOptions& options = {});

}  // namespace coapt
