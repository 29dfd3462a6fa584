// What a repair plan asks of the patient.
#pragma once

#include "core/repair/plan.h"
#include "core/repair/ring_sizing.h"

namespace coapt {

struct Effort {
  double anterolateral_movement_mm = 0.0;  ///< of the papillary muscle
  double posteromedial_movement_mm = 0.0;
  double sizes_below = 0.0;  ///< ring_sizes_below(); 0 if the annulus is left as it is
  int steps = 0;
};

/// From the valves before and after a plan. Each muscle moves as a whole: its first head tells.
Effort effort(const Valve& before, const Valve& repaired, const RepairPlan& plan);

}  // namespace coapt
