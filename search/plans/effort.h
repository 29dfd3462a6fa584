// What a repair plan asks of the patient.
#pragma once

#include "core/repair/plan.h"

namespace coapt {

struct Effort {
  double anterolateral_movement_mm = 0.0;  ///< of the papillary muscle
  double posteromedial_movement_mm = 0.0;
  double sizes_below = 0.0;  ///< see ring_sizes_below(); 0 if the annulus is left as it is
  int steps = 0;
};

/// How small an annulus was made, in ring sizes: by how many steps of 2 mm transverse a healthy
/// annulus of the transverse diameter before (AP 0.75 of it) would have to shrink to the area
/// after. A ring that only restores the healthy proportion counts 0; a short, wide one counts by
/// what it takes away.
double ring_sizes_below(const Valve& before, const Valve& repaired);

/// From the valves before and after a plan. Each muscle moves as a whole: its first head tells.
Effort effort(const Valve& before, const Valve& repaired, const RepairPlan& plan);

}  // namespace coapt
