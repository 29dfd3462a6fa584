// Which closures of a plan others of it are predicted from (core/closure/predicted_start.h).
//
// A few closures of a plan are its frame: in the region opposite nodes, which come in pairs, of one
// muscle alone the ends of the axes and of the diagonals. The frame starts from the plan as planned,
// the second node of a pair from the first one's opposite; all others start from what the frame
// lets expect, linear with little of a frame, quadratic with all of it. A disturbance that the
// nodes before it do not span is not predicted.
//
// Everything here is a function of the disturbance's index alone, not of the plan, of what else is
// closed or of threads: so the frame can be closed again, to the same bits, where it is needed
// later. In the region only nodes of lower index are taken, so that few nodes cost nothing more.
#pragma once

#include <vector>

#include "search/plans/disturbance.h"

namespace coapt {

struct FrameShare {
  int disturbance = 0;
  double share = 0.0;  ///< may be negative; their sum is 1
};

/// None: it starts from the plan as planned.
const std::vector<FrameShare>& predicted_from(int disturbance);

/// 0 for the plan as planned, 1 for what starts from it, else one more than the highest that it is
/// predicted from.
int frame_level(int disturbance);

/// Whether others are predicted from it.
bool in_frame(int disturbance);

}  // namespace coapt
