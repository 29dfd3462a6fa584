// How sure it is that one plan is better than another.
#pragma once

#include "search/plans/plan_evaluations.h"

namespace coapt {

/// What a plan is closed as, and what else is known of it.
struct JudgedRecord {
  const PlanRecord* plan = nullptr;
  bool closes_finely = true;
  double cost_change = 0.0;  ///< by what a finer mesh, opening and durability say
};

/// That `a` comes before `b`, by robust closing, then by cost: the share of resamples of the
/// region's nodes (the same for both, bootstrap, Efron 1979), each with an error of the mean leak
/// as large as that between closures of one plan from different starts. Not the error of the model.
/// NaN below two nodes. @pre both are closed at `nodes` nodes.
double probability_ahead(const PlanEvaluations& evaluations, const JudgedRecord& a,
                         const JudgedRecord& b, int nodes);

}  // namespace coapt
