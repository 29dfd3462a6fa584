// What a search minimises: one number per plan, in mm2 of leak (the larger of orifice and hidden
// gap).
//
// Competence first: above 1 mm2 a leak costs six times as much, more than any operation. Then mean
// + sd of the leak under the disturbances (plans/disturbance.h). Where nothing leaks, and a picture
// of it says nothing more, the cost still slopes: towards more coaptation, a disturbance that leaks
// further away, less force in the chordae, and less surgery.
#pragma once

#include <span>

#include "core/repair/plan.h"
#include "search/plans/plan_closure.h"

namespace coapt {

/// Leak that a good repair leaves at most (thesis 4.2.3).
inline constexpr double kGoodRepair_mm2 = 5.0;
/// Leak (orifice and hidden gap) below which a closed valve counts as competent.
inline constexpr double kCompetentLeak_mm2 = 1.0;
/// Coaptation of A2 with P2: an aim of surgeons, evidence is weak.
inline constexpr double kCoaptationAim_mm = 8.0;

/// What a plan asks of the patient.
struct Effort {
  double anterolateral_movement_mm = 0.0;  ///< of the papillary muscle
  double posteromedial_movement_mm = 0.0;
  double sizes_below = 0.0;  ///< see ring_sizes_below(); 0 if the annulus is left as it is
  int steps = 0;
};

/// How small an annulus was made, in ring sizes: by how many steps of 2 mm transverse a healthy
/// annulus of the transverse diameter before (AP 0.75 of it) would have to shrink to the area
/// after. A ring that only restores the healthy proportion counts 0; a short, wide one counts by
/// what it takes away.
double ring_sizes_below(const Valve& before, const Valve& repaired);

Effort effort(const Valve& before, const Valve& repaired, const RepairPlan& plan);

/// Prices in mm2, each in [0, 1e6]. They are judgements, not measurements: competence may never be
/// outbid by comfort, and between competent plans the lesser operation wins.
struct CostWeights {
  /// Per mm2 of mean + sd_share x sd.
  double leak = 1.0;
  /// Sds that count beside the mean: thesis 4.2.3 compares both.
  double sd_share = 1.0;
  /// More, per mm2 of that above 1: 1 mm2 outbids a whole step.
  double incompetence = 5.0;
  /// For a plan that leaks at once; none if no disturbance makes it leak.
  double margin = 1.0;
  /// Per mm that A2 with P2 falls short of 8; weak evidence.
  double coaptation = 0.5;
  /// Per mm by which leaflets are further apart than they are thick.
  double gap = 2.0;
  /// Per mm of papillary movement.
  double movement = 0.2;
  /// More, per mm above what is usual.
  double movement_above_10 = 1.0;
  /// Per size: less annulus to move, and less opening, of which gradient_above_3 sees the narrow end alone.
  double undersizing = 0.5;
  /// More, per size above what practice accepts.
  double undersizing_above_4 = 2.0;
  /// Per step: each costs time on bypass.
  double step = 1.0;
  /// Per newton of peak chordal tension above the unrepaired valve's.
  double tension = 1.0;
  /// Per mmHg of mean gradient in diastole above 3, what usual rings leave (plan_opening.h).
  double gradient_above_3 = 2.0;
  /// More, per mmHg above 5.
  double gradient_above_5 = 10.0;
  /// Per mm of disease that the repair does not last, of 12 (durability.h); of reported plans alone.
  double durability = 0.25;
  /// For closures that did not converge or crossed, by their share.
  double untrusted = 1e4;
};

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

/// @param closures at least one, the first as planned; the same disturbances for all plans that are
/// compared. Never NaN.
double plan_cost(std::span<const ScoredClosure> closures, const Effort& effort,
                 const CostContext& context);

}  // namespace coapt
