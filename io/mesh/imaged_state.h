// Whether leaflets were imaged open, half closed or closed.
//
// Measured: the share of the annulus's area, seen along its axis, that no sheet covers. A pixel is covered where a
// triangle lies over or under it, or within half the leaflet's thickness of one that does: mid-surfaces of leaflets that
// touch are a thickness apart.
#pragma once

#include "core/closure/closure_options.h"
#include "io/mesh/mesh_file.h"

namespace coapt {

enum class ImagedState { Open, HalfClosed, Closed };

struct StateSigns {
  ImagedState state = ImagedState::Open;
  double uncovered_share = 0.0;  ///< of the annulus's projected area
};

/// @param annulus_mm closed loop; in any frame. @param thickness_mm of thick leaflets, or of tissue. @param budget cancelled:
/// not all triangles are looked at
StateSigns imaged_state(const std::vector<TriangleMesh>& leaflets, const Points& annulus_mm,
                        double thickness_mm, const ClosureBudget& budget = {});

}  // namespace coapt
