// What a surgeon should know about a plan before liking it. A plan is never dropped for a warning.
#pragma once

#include <string>
#include <vector>

#include "search/objective.h"
#include "search/search.h"

namespace coapt {

/// @param plan all but its warnings. @param before the unrepaired valve's closure.
std::vector<std::string> plan_warnings(const RankedPlan& plan, const Valve& valve,
                                       const std::vector<RingShape>& catalogue,
                                       const Evaluation& before);

}  // namespace coapt
