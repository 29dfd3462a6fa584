// Regions of a plane from their cuts by scan lines.
#pragma once

#include <vector>

#include "core/metrics/openings.h"

namespace coapt {

/// A piece of the scan line x = at_mm that lies open.
struct OpenInterval {
  int line = 0;              ///< lines are counted in the direction of x
  double at_mm = 0.0;        ///< x
  double weight_mm = 0.0;    ///< breadth in x that it speaks for
  double from_mm = 0.0;      ///< y
  double to_mm = 0.0;        ///< y, greater
  int below = 0, above = 0;  ///< ScanBound::number of what bounds it there
};

/// Joins intervals of neighbouring lines that one edge, or two that meet, bound on the same side,
/// and those that overlap with no bound between them; largest region first. Areas and moments are
/// sums over the intervals. Contours run through their ends, less points within 1e-3 mm of a
/// straight line.
/// @param intervals line by line, in the direction of y in each, disjoint there.
std::vector<Opening> joined_intervals(const std::vector<OpenInterval>& intervals);

}  // namespace coapt
