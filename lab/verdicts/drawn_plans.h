// Plans as a search might try them, at random.
#pragma once

#include <cstdint>
#include <vector>

#include "core/repair/plan.h"
#include "core/valve/valve.h"

namespace coapt {

/// Distinct plans of the valve's plan space: a branch uniformly, then a point of its lattice uniformly;
/// left out is what the valve does not allow or operation_gates() rejects. At most `count`, fewer if
/// so many are hardly found. The same arguments give the same plans.
std::vector<RepairPlan> draw_plans(const Valve& valve, int count, std::uint64_t seed);

}  // namespace coapt
