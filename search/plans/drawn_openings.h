// What tissue and the hand make of an opening: a plan, or the valve as it is, opened again in some draws of the model
// (model_closures.h) and with some of the errors of sewing and tying (disturbance.h).
#pragma once

#include <vector>

#include "search/plans/model_closures.h"
#include "search/plans/plan_evaluations.h"

namespace coapt {

/// Of either at most, evenly among them.
inline constexpr int kDrawnOpenings = 16;

/// Those that were made, to be trusted or not.
struct DrawnOpenings {
  std::vector<PlanOpening> draws, errors;
};

/// Of each plan whose opening as planned is to be trusted, on all threads; none without an opener, and fewer if the search was cancelled.
/// @param plans null: the valve as it is, which no hand has touched
std::vector<DrawnOpenings> open_under_draws(const PlanEvaluations& evaluations,
                                            const std::vector<const PlanRecord*>& plans,
                                            const ModelClosures& model);

}  // namespace coapt
