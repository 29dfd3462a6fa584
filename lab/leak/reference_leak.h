// The leak by definition, slowly: the least area of a surface in the blood that parts atrium from ventricle, leaflets with half their
// thickness on either face. What the product's measure is judged by; it shares nothing with it but the definition.
//
// Minimal cuts (minimal_cut.h) on voxels of 1, 1/2, 1/4 mm and so on, each level in a band around the last one's cut. Outside the
// annulus a skirt goes on to the end of the lattice.
//
// Accuracy: a cut that lies askew to the voxels has steps, which count too much: 2 to 5 % at 0.25 mm, and what is left of that falls with
// the voxel. The area is therefore that of the surface itself (cut_surface.h), or the voxels' where that is less. On shapes whose area is
// known, flat and tilted by up to 50 degrees, it is within 0.5 % at 0.25 mm (tests/lab/leak); of a valve turned into its mirror images it
// differs by 0.5 %. Coarser levels than 0.5 mm leak through every leaflet, and are guides only.
// Limits: leaflets of two finest voxels' thickness or more; a cut that the band misses is not seen.
#pragma once

#include "lab/leak/minimal_cut.h"

namespace coapt {

struct ReferenceOptions {
  double finest_mm = 0.25;  ///< the last level's voxel: 0.5, 0.25 or 0.125
  double band_mm = 3.5;     ///< either side of the last level's cut
};

struct ReferenceLevel {
  double voxel_mm = 1.0;
  int cells = 0, iterations = 0;
  double primal_mm2 = 0.0, dual_mm2 = 0.0;  ///< the voxels' least area lies between
  int widened = 0;  ///< how often the band was made twice as wide, because the cut touched its end
};

/// A connected part of the finest level's cut. All of them together have the leak's area, but for specks of less than 0.05 mm2.
struct ReferenceOpening {
  double area_mm2 = 0.0;
  Vec3 centroid_mm = Vec3::Zero();
  Vec3 normal = Vec3::UnitZ();  ///< unit, to the atrium
};

struct ReferenceLeak {
  double area_mm2 = 0.0;                    ///< the least of the two below
  double surface_mm2 = 0.0;                 ///< in the blood, of the finest level's surface
  double primal_mm2 = 0.0, dual_mm2 = 0.0;  ///< of its voxels: their mean counts
  std::vector<ReferenceOpening> openings;   ///< largest first
  std::vector<ReferenceLevel> levels;       ///< coarse to fine
};

/// Deterministic, on one thread. Of a closed valve 0.25 mm takes seconds.
ReferenceLeak reference_leak(const LeakSurface& surface, const ReferenceOptions& options = {});

}  // namespace coapt
