// What a search minimises: one number per plan, in mm2 of leak (the larger of orifice and hidden gap).
//
// Competence first. Where the orifice is zero, and a picture of it says nothing more, the cost
// still slopes: towards more coaptation, no hidden gap, less force in the chordae, and less
// surgery.
#pragma once

#include "core/repair/plan.h"
#include "search/evaluator.h"

namespace coapt {

/// Leak that a good repair leaves at most (thesis 4.2.3).
inline constexpr double kGoodRepair_mm2 = 5.0;

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

/// Prices in mm2. They are judgements, not measurements: competence may never be outbid by comfort,
/// and between competent plans the lesser operation wins.
struct CostWeights {
  double leak = 1.0;          ///< per mm2
  double leak_above_5 = 2.0;  ///< more, per mm2 above the thesis's limit of a good repair (4.2.3)
  double coaptation =
      0.5;                ///< per mm that the height of A2 with P2 falls short of 8; weak evidence
  double gap = 2.0;       ///< per mm by which leaflets are further apart than they are thick
  double movement = 0.2;  ///< per mm of papillary movement
  double movement_above_10 = 1.0;  ///< more, per mm above what is usual
  double undersizing = 0.5;        ///< per size: less opening in diastole, which systole cannot see
  double undersizing_above_4 = 2.0;  ///< more, per size above what practice accepts
  double step = 1.0;                 ///< per step: each costs time on bypass
  double tension = 1.0;       ///< per newton of peak chordal tension above the unrepaired valve's
  double untrusted = 1000.0;  ///< for a closure that did not converge or crossed
};

/// Of moving one papillary muscle, mm2.
double movement_price(double movement_mm, const CostWeights& weights = {});

/// @param tension_before_n peak tension of the unrepaired valve. Never NaN.
double cost(const Evaluation& evaluation, const Effort& effort, double thickness_mm,
            double tension_before_n, const CostWeights& weights = {});

}  // namespace coapt
