// Whether what a plan's disturbed closures start from (disturbance_frame.h) decides where they end: a
// sample of them, closed again from the open state.
#pragma once

#include <optional>

#include "search/plans/plan_evaluations.h"
#include "search/start_comparison.h"

namespace coapt {

/// Most disturbed closures of a sample.
inline constexpr int kStartSample = 8;
/// Of the region's nodes 1 to `nodes` - 1, evenly spread over their indices. Two closures each, which
/// nothing counts, on all threads. None if there are no such nodes, if the evaluator keeps no
/// closures or the search was cancelled before.
std::optional<StartCheck> check_starts(PlanEvaluations& evaluations, const PlanRecord& plan,
                                       int nodes);

}  // namespace coapt
