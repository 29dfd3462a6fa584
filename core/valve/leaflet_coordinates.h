// Mesh-independent coordinates of the leaflets, so that a repair plan means the same on every mesh.
//
// Along: harmonic extension of the annulus arc into the skirt with a natural free edge; height:
// harmonic between 0 at the annulus and 1 at the free edge (Laplacian of the rest mesh, cotangent
// weights).
#pragma once

#include <vector>

#include "core/valve/valve.h"

namespace coapt {

/// Per vertex: `around` in [0, 1), counter-clockwise seen from the atrium with the posteromedial
/// commissure at 0, the saddle peak at 0.25, the anterolateral commissure at 0.5 and mid-posterior
/// at 0.75, linear in annulus arc length (under pressure) between them; `height` in [0, 1].
struct LeafletCoordinates {
  std::vector<double> around;
  std::vector<double> height;
};

LeafletCoordinates leaflet_coordinates(const Valve& valve);

/// |A|, `around` of each annulus vertex, in the order of Valve::annulus.
std::vector<double> annulus_around(const Valve& valve);

/// Position under pressure on the annulus at `around` (as above, any real number, wraps).
Vec3 annulus_point_mm(const Valve& valve, double around);

}  // namespace coapt
