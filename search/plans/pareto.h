// Plans that no other one beats.
#pragma once

#include <vector>

#include "search/plans/plan_evaluations.h"
#include "search/plans/search_result.h"

namespace coapt {

/// By three objectives, to the digits that are printed (0.1 mm2, 0.1 cm2, 0.1 mm): mean + sd of the leak, opening, durability; then, where all are
/// alike, by the effort. Unless all plans were opened the effort stands for the opening; durability that is not known of all is left
/// out; a plan whose closures fail, or that is_stenotic(), is in no front.
///
/// Sets RankedPlan::pareto, beaten_by and beaten_in; of ranked plans the effort is what makes one simpler by the rule that ranks (plan_order.h).
void mark_pareto(std::vector<RankedPlan>& plans);

/// Of plans closed at `nodes`, cheapest first; the effort is its price. Where what some trade is known (trade_off.h), of these alone.
std::vector<ParetoPlan> pareto_front(const PlanEvaluations& evaluations,
                                     const std::vector<const PlanRecord*>& plans, int nodes);

}  // namespace coapt
