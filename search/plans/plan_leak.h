// What is known of the leak of a plan, or of the valve as it is: by its finer mesh, the draws of the model and the region.
//
// Over draws and nodes leaks are estimated (LeakBy): what they change is added to the leak as planned, which is measured.
#pragma once

#include "core/metrics/estimate.h"
#include "search/plans/fine_closures.h"
#include "search/plans/model_closures.h"
#include "search/plans/plan_evaluations.h"

namespace coapt {

/// @param measure as planned; @param nodes of the region, closed ones
Estimate plan_leak(const PlanRecord& plan, const ValveMeasure& measure, int nodes,
                   const FineClosures& fine, const ModelClosures& model);

/// Of the valve that nothing was done to. @param before closed and measured, @param estimated_mm2 its leak as a search estimates it
Estimate leak_before(const ValveMeasure& before, double estimated_mm2, const FineMesh& fine,
                     const ModelClosures& model);

}  // namespace coapt
