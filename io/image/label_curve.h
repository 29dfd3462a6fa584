// The closed line that a label about an annulus follows.
//
// In the label's principal plane (that of its two longest axes) its voxels are sorted by angle about the middle; each angle
// has the mean of its voxels, gaps up to 15 degrees are bridged, and the line is smoothed by 1-2-1 twice round. A gap up to 60
// degrees stays one, which contour_checks() finds.
//
// Assumed: a ring that is star-shaped about its middle, seen along its axis, and thin against its width. Refused: what is no
// ring. Limits: 72 points; a saddle of 8 mm loses less than 0.1 mm of its height.
#pragma once

#include "io/image/label_map.h"

namespace coapt {

/// 72 points, LPS mm, fewer with a gap. Errors: no such label, or it is no ring.
Expected<Points> label_curve(const LabelMap& map, const LabelAt& label);

}  // namespace coapt
