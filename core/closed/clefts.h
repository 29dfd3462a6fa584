// Clefts of the posterior leaflet that leak: its free edge runs up towards the annulus between two scallops, and blood passes there.
#pragma once

#include <vector>

#include "core/metrics/measure.h"

namespace coapt {

/// Less of the leaflet's height is an indentation, which seals: the calibrated healthy valve leaks at its clefts from a third on.
inline constexpr double kDeepCleft = 0.25;

struct Cleft {
  Segment first = Segment::P1, second = Segment::P2;  ///< on either side of it
  double along = 0.0;                                 ///< of its root, LeafletPoint::along
  double depth_mm =
      0.0;  ///< of its root below the line that joins the middles of both scallops' edges, unstressed
  double share = 0.0;     ///< of the leaflet's height at that line
  double leak_mm2 = 0.0;  ///< that passes beside its root
};

/// From the anterolateral side on: kDeepCleft deep at least, with more than `least_mm2` of the leak nearer to its root than it is deep.
/// @param closed_mm the valve's vertices. @pre the valve is mitral.
std::vector<Cleft> leaking_clefts(const Valve& valve, const Points& closed_mm,
                                  const ValveMeasure& measure, double least_mm2);

/// Sum over clefts.
double leak_through(const std::vector<Cleft>& clefts);

}  // namespace coapt
