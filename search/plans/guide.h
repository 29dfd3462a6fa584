// What a search climbs by: the rule that ranks (plan_order.h) as one number, in steps of an operation.
//
// What the rule holds to be alike costs little here, and what it ranks by comes in its order: a plan that is not acceptable costs more than
// warnings, these more than durability, that more than steps, muscles and undersizing. Durability takes closures of its own, which plans
// get at the last rung of the ladder; before, coaptation and the nearest disturbance that leaks stand for it.
#pragma once

#include "search/plans/cost_terms.h"
#include "search/plans/effort.h"

namespace coapt {

/// In steps. Of what is acceptable a leak costs little; what is not it leads there.
inline constexpr CostWeights kGuideWeights = {
    .leak = 0.05,
    .incompetence = 0.0,
    .margin = 0.5,
    .coaptation = 0.1,
    .gap = 0.0,
    .movement = 0.01,
    .movement_above_10 = 0.5,
    .undersizing = 0.1,
    .undersizing_above_4 = 1.0,
    .step = 1.0,
    .tension = 0.0,
    .gradient_above_3 = 0.5,
    .gradient_above_5 = 10.0,
    .durability = 0.75,
    .untrusted = 200.0,
};

/// What is known of an operation before it is closed.
struct OperationMerits {
  Effort effort;
  int muscles = 0;       ///< that a suture moves
  int free_anchors = 0;  ///< of sutures
  int resections = 0;
  int avoidable_warnings =
      0;  ///< of operation_gates(), and of the closure as planned once it is known
};

/// Of the operation alone: no plan costs less.
double least_guide(const OperationMerits& operation);

/// @param terms of its closures and what its opening and its durability cost. @param mild mean of probability_mild() of these closures, 0 of those that are not
/// trusted
double guide(const CostTerms& terms, double mild, const OperationMerits& operation);

}  // namespace coapt
