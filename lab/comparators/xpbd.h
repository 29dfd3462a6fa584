// Comparator `xpbd`: extended position-based dynamics in small steps, as games and surgical trainers
// close soft tissue, for the map of stability alone.
#pragma once

#include "core/closure/contact.h"
#include "core/closure/model.h"
#include "core/closure/run.h"

namespace coapt::comparators {

struct XpbdSettings {
  double residual_tolerance = 0.01;
  int max_steps = 6000;  ///< substeps
  double substep = 1.0;  ///< factor on the substep
  double keep =
      0.97;  ///< share of a velocity left after one; 0.94 needs more than twice the steps where soft
  double longest_move_mm = 0.15;  ///< of a node in a substep
  ContactLaw contact;
};

/// @pre the model's membrane is springs.
ClosureRun run_xpbd(const ClosureModel& model, const XpbdSettings& settings);

}  // namespace coapt::comparators
