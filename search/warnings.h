// What a surgeon should know about a plan before liking it. A plan is never dropped for a warning.
#pragma once

#include <string>
#include <vector>

#include "search/objective.h"
#include "search/search.h"

namespace coapt {

struct Operation {
  const RepairPlan& plan;
  const Valve& valve;     ///< before
  const Valve& repaired;  ///< apply_plan() of these
  const std::vector<RingShape>& catalogue;
};

/// Of what is done, whether or not the valve then closes.
std::vector<std::string> operation_warnings(const Operation& operation);

/// Of how the repaired valve closes. @param plan all but its warnings. @param before the unrepaired
/// valve's closure.
std::vector<std::string> closure_warnings(const RankedPlan& plan, const Evaluation& before);

}  // namespace coapt
