// What a search minimises: one number per plan, in mm2 of leak.
//
// Competence first: above 1 mm2 a leak costs six times as much, more than any operation. Then mean
// + sd of the leak under the disturbances (plans/disturbance.h). Where nothing leaks, and a picture
// of it says nothing more, the cost still slopes: towards more coaptation, a disturbance that leaks
// further away, less force in the chordae, and less surgery.
#pragma once

#include <span>

#include "core/closed/diagnosis.h"
#include "search/plans/cost_terms.h"
#include "search/plans/effort.h"
#include "search/plans/plan_closure.h"

namespace coapt {

/// Coaptation of A2 with P2: an aim of surgeons, evidence is weak.
inline constexpr double kCoaptationAim_mm = 8.0;

/// Of moving one papillary muscle, mm2.
double movement_price(double movement_mm, const CostWeights& weights = {});

/// What the operation itself costs: no plan costs less, whatever its closures show.
double effort_price(const Effort& effort, const CostWeights& weights = {});

/// A closure with how far its disturbance goes: 0 as planned, 1 at the border of the region.
struct ScoredClosure {
  PlanClosure closure;
  double disturbance = 0.0;
};

struct CostContext {
  double thickness_mm = 1.0;
  double tension_before_n = 0.0;  ///< peak of the unrepaired valve
  CostWeights weights;
};

/// What effort_price() is of.
CostTerms effort_terms(const Effort& effort);

/// @param closures at least one, the first as planned; the same disturbances for all plans that are
/// compared. Never NaN.
CostTerms cost_terms(std::span<const ScoredClosure> closures, const Effort& effort,
                     const CostContext& context);

/// price() of these.
double plan_cost(std::span<const ScoredClosure> closures, const Effort& effort,
                 const CostContext& context);

}  // namespace coapt
