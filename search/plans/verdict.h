// What the ranking comes to, in words.
#pragma once

#include <string>
#include <vector>

#include "search/plans/search_result.h"

namespace coapt {

/// "its mean gradient at rest is 5.6 mmHg, above 5 mmHg"; empty of one that is acceptable.
std::string why_not_acceptable(const RankedPlan& plan);

/// "errors of execution, tissue and mesh", as far as the plan's probability knows them.
std::string known_errors(const RankedPlan& plan);

/// Whether the first plan is acceptable, which plans cannot be told apart from it, and whether its anchors matter: "Plans 1 to 3 cannot be told
/// apart; plan 1 is the simplest of them. It leaks less than 5 mm² with a probability of 97 %, over errors of execution, tissue and mesh."
/// @param plans as ranked. @return empty without plans
std::string verdict_of(const std::vector<RankedPlan>& plans);

}  // namespace coapt
