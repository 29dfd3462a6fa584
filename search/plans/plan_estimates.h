// What is known of a plan's figures that gates and rules of practice use, or of the valve as it is: by the finer mesh, the draws of the
// model and the region.
//
// Over draws leaks are measured. Over nodes they are estimated (LeakBy): what they change is added to the leak as planned, which is measured.
// Durability is found once: of it only the numerical error is known.
#pragma once

#include "core/metrics/estimate.h"
#include "search/plans/drawn_openings.h"
#include "search/plans/fine_closures.h"
#include "search/plans/model_closures.h"
#include "search/plans/plan_evaluations.h"

namespace coapt {

/// A value that is NaN is not known.
struct PlanEstimates {
  Estimate leak_mm2{};
  Estimate coaptation_mm{};  ///< of A2 with P2 (PlanClosure)
  Estimate tension_max_n{};  ///< of all chordae and neochordae
  Estimate
      leaflet_ratio{};  ///< by which systolic anterior motion is a risk; over those closures where the leaflets touch
  Estimate strain_circumferential{},
      strain_radial{};  ///< no rule uses them: of the numerical error alone
  Estimate opening_mm2{}, gradient_mmhg{};
  Estimate durability_mm{};
};

/// @param measure as planned; @param nodes of the region, closed ones
PlanEstimates plan_estimates(const PlanEvaluations& evaluations, const PlanRecord& plan,
                             const ValveMeasure& measure, int nodes, const FineClosures& fine,
                             const ModelClosures& model);

/// Of the valve that nothing was done to: no hand has touched it, and how long it lasts is not asked.
PlanEstimates estimates_before(const PlanEvaluations& evaluations, const ValveMeasure& measure,
                               const std::optional<PlanOpening>& opening, const FineMesh& fine,
                               const ModelClosures& model);

/// Of opening and gradient, by those that are to be trusted; nothing of an opening that is not.
void add_spread(PlanEstimates& estimates, const std::optional<PlanOpening>& own,
                const DrawnOpenings& drawn);

}  // namespace coapt
