// The rules that hold of how a repaired valve closes.
#pragma once

#include <vector>

#include "search/evaluator.h"
#include "search/plans/gates.h"

namespace coapt {

/// Of how the repaired valve closes as planned: "convergence", "crossing", "contact",
/// "coaptation_height", "chordal_tension", "systolic_anterior_motion", "regurgitation_grade". Always these, in this order;
/// figures of a closure that is not to be trusted are not assessed.
/// @param tethered the valve's leaflets are tethered and none prolapses: signs of systolic anterior motion were not found on such valves
std::vector<Gate> closure_gates(const Evaluation& repaired, const Evaluation& before,
                                bool tethered = false);

}  // namespace coapt
