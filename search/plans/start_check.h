// Whether what a plan's disturbed closures start from decides where they end: a sample of them,
// closed again from the open state.
//
// A folded leaflet may come to rest in more than one way. Predicted starts (disturbance_frame.h)
// keep all closures of a plan near the one that the plan itself took; how many of them a cold start
// would lead elsewhere says how much of the evidence hangs on that.
#pragma once

#include <optional>

#include "search/plans/plan_evaluations.h"

namespace coapt {

/// Most disturbed closures of a sample.
inline constexpr int kStartSample = 8;
/// Rms distance of the leaflets from which on two closures count as different. Each may be 0.03 mm
/// from its own end.
inline constexpr double kElsewhere_mm = 0.1;

struct StartCheck {
  int closures = 0;   ///< in the sample, trusted both ways
  int elsewhere = 0;  ///< of these
  double leak_difference_max_mm2 = 0.0;
};

/// Of the region's nodes 1 to `nodes` - 1, evenly spread over their indices. Two closures each, which
/// nothing counts, on all threads. None if there are no such nodes, if the evaluator keeps no
/// closures or the search was cancelled before.
std::optional<StartCheck> check_starts(PlanEvaluations& evaluations, const PlanRecord& plan,
                                       int nodes);

}  // namespace coapt
