// How likely a repaired valve is to leak mildly at most, over all errors at once: those of the hand (nodes of the region), of tissue (draws of
// the model) and of the mesh (core/metrics/area_error.h).
#pragma once

#include <Eigen/Core>

#include "search/plans/fine_closures.h"
#include "search/plans/model_closures.h"
#include "search/plans/plan_evaluations.h"

namespace coapt {

/// Probability that a plan leaves less than kMildLeak_mm2, over the error of the mesh alone.  [node][draw]: a draw moves the leak of
/// every node by as much as that of the plan as planned, and so does the finer mesh. 0 where a closure is not to be trusted. Where nothing is
/// done no hand errs: all nodes are the valve as it is.
using Acceptance = Eigen::ArrayXXd;

/// @param nodes closed ones. @param model without draws: one column
Acceptance acceptance_of(const PlanEvaluations& evaluations, const PlanRecord& plan, int nodes,
                         const FineClosures& fine, const ModelClosures& model);

/// That `a` is rightly before `b`: the share of draws, each with resamples of the region's nodes (the same for both, bootstrap, Efron
/// 1979), in which it is acceptable (plan_order.h) or, where neither is, likelier to be mild; as much acceptable counts half.
/// (k + 1) / (n + 2), so that it is never certain.
double probability_ahead(const Acceptance& a, const Acceptance& b);

}  // namespace coapt
