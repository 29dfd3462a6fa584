// A projected valve's leaflets as tissue in the plane: outlines instead of faces.
//
// Faces seen from the atrium and faces seen from the ventricle are taken apart; each kind is
// replaced by its outline, a fifth of the edges or less. A face seen edge-on covers nothing by
// itself and grows to its full thickness: its longest edge is kept as a line. Corners are rounded
// to the grid (plane_grid.h).
#pragma once

#include "core/metrics/openings.h"
#include "core/metrics/projection.h"

namespace coapt {

/// @param projection of this valve, finite.
FlatTissue silhouette(const Valve& valve, const Projection& projection);

}  // namespace coapt
