// Plans that no other one beats.
#pragma once

#include <vector>

#include "search/plans/plan_evaluations.h"
#include "search/plans/search_result.h"

namespace coapt {

/// Of plans that may be compared (equally many nodes): no other is as good in mean, sd, steps and opening, and better in
/// one. Undersizing stands for the opening unless all were opened.
std::vector<ParetoPlan> pareto_front(const PlanEvaluations& evaluations,
                                     const std::vector<const PlanRecord*>& plans, int nodes);

/// Sets RankedPlan::pareto by three objectives, to the digits that are printed (0.1 mm2, 0.1 cm2, 0.1 mm): mean + sd of the leak, opening,
/// durability; then, where all are alike, by the price of the operation. Unless all plans were opened the price stands for the opening; durability that is not known of all is left out; a plan whose
/// closures fail, or that is_stenotic(), is in no front.
void mark_pareto(const CostWeights& weights, std::vector<RankedPlan>& plans);

}  // namespace coapt
