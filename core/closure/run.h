// One attempt at closing: what every method returns to close_valve.
#pragma once

#include <vector>

#include "core/closure/closure_result.h"

namespace coapt {

struct ClosureRun {
  ClosureStatus status = ClosureStatus::StepLimit;
  Points x_mm;                     ///< |N| x 3, all nodes, order of ClosureModel
  std::vector<Points> samples_mm;  ///< |V| x 3 each: end states; empty unless converged
  /// |N| x 3 each: states on the way, start and end included, where asked for.
  std::vector<Points> motion_mm;
  double residual = 0.0;
  int steps = 0;
  int crossing_pairs = 0;  ///< of faces, that pass through each other at the end, unless diverged
  std::vector<int> guarded_faces;  ///< Fast: that began with edge contact, or took it up on the way
};

/// Whether a node has left the scene or is not a number any more.
bool has_diverged(const Points& x_mm);

}  // namespace coapt
