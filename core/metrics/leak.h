// The leak: the least area of a surface in the blood that parts atrium from ventricle, leaflets with half their thickness on either face.
// One measure of closed and open valves, clips and clefts alike.
//
// Where it lies is found among voxels of 1 mm by a maximal flow (atrial_side.h), how large it is by a continuous minimal cut among
// voxels of 0.5 mm in a band about there (least_surface.h), which is widened where the cut reaches its border. Beyond the annulus a wall
// runs outwards from it. The voxels stand along the annulus's own axes, so that a valve that is moved or turned has the same leak.
// Accuracy, on 100 valves that nothing was chosen on (docs/researcher/accuracy.md): above 5 mm2 0.4 % too small in the mean, median error 1.0 %,
// nine of ten within 2.2 %; below 0.07 mm2 in the mean. It moves by 0.15 mm2 at most when vertices move by 0.01 mm.
// Limits: places that are narrow alike along a wide way are told apart to 1 mm; a throat within half a voxel of the rim reads too large by up
// to 0.03 mm times its length.
#pragma once

#include <limits>
#include <vector>

#include "core/metrics/opening_surface.h"
#include "core/valve/valve.h"

namespace coapt {

/// A connected part of the surface.
struct LeakOpening {
  double area_mm2 = 0.0;
  Vec3 centroid_mm = Vec3::Zero();
  Vec3 normal = Vec3::UnitZ();  ///< unit, towards the atrium
  std::vector<Segment>
      segments;  ///< of the leaflets around it, the longest part of its rim first; none of a valve that is not mitral
  double width_mm = 0.0;   ///< of the largest ball that passes
  OpeningSurface surface;  ///< in the valve's own axes, up to the face of the tissue
};

struct Leak {
  /// NaN of points that are not finite, or farther than kMostReach_mm from the annulus: a closure that flew apart.
  double area_mm2 = std::numeric_limits<double>::quiet_NaN();
  /// Between these it lies on these voxels.
  double lower_mm2 = std::numeric_limits<double>::quiet_NaN(),
         upper_mm2 = std::numeric_limits<double>::quiet_NaN();
  std::vector<LeakOpening> openings;  ///< largest first
};

inline constexpr double kMostReach_mm = 200.0;

/// @param points_mm |V| x 3, of a closed or an open valve
Leak measure_leak(const Valve& valve, const Points& points_mm);

}  // namespace coapt
