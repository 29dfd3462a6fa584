// What is tied, and whether it would hold.
#pragma once

#include "search/plans/gates.h"
#include "search/plans/plan_evaluations.h"

namespace coapt {

/// "neochorda_strength", "ring_sutures": always these, in this order; a rule without a subject passes. The peak tension of all
/// chordae stands for that of the neochordae, which is no larger.
std::vector<Gate> strength_gates(const PlanRecord& plan);

}  // namespace coapt
