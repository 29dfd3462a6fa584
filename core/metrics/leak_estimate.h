// What a search knows of a leak before it measures the least surface (leak.h), in a twentieth of the time: the larger of the orifice in
// the atrial view and of the gap between the sides.
//
// Accuracy, on 100 valves, repaired and not, on which nothing was chosen: 6 % too small in the mean
// (sd 12 %), half within 8 %, nine of ten within 22 %, the worst 42 %; below 5 mm2 within 0.3 mm2 in the mean, 2.2 at worst
// (docs/researcher/accuracy.md). Limits: folds beside the commissures, clips and flail segments, which read too small.
#pragma once

#include "core/valve/valve.h"

namespace coapt {

/// Of a valve that is not mitral the orifice alone. NaN of points that are not finite; infinite if a mitral valve has one side only.
double estimate_leak_mm2(const Valve& valve, const Points& closed_mm);

}  // namespace coapt
