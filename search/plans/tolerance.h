// "What if I am a millimetre off": the leak over the error of one step of a plan, all others as planned.
//
// A suture is tied longer or shorter or sewn beside its anchor, a neochorda is longer or its stitch lies elsewhere, a ring is of
// another size. Each is closed at one, two and three units of its error to either side: the first from the plan's own closure, the
// next from the line through the last two (core/closure/predicted_start.h). The page asks the same of a step by hand
// (clients/web/src/repair/errors.ts).
#pragma once

#include <string>
#include <vector>

#include "search/plans/plan_evaluations.h"

namespace coapt {

enum class StepError {
  RingSize,            ///< transverse
  SutureLength,        ///< above 0: too long
  SutureAnchor,        ///< along the annulus; above 0: anticlockwise seen from the atrium
  NeochordaLength,     ///< above 0: too long
  StitchAlongLeaflet,  ///< above 0: towards the posteromedial commissure
  StitchTowardsEdge,   ///< above 0: towards the free edge
};
const char* to_string(StepError error);  ///< "ring_size", "suture_length", "suture_anchor", ...

struct ToleranceCurve {
  int step = 0;  ///< index in RepairPlan::steps
  StepError error = StepError::RingSize;
  /// Ascending, 0 among them; what no surgeon could do (a slack suture, a ring that is not made) is left out.
  std::vector<double> error_mm;
  std::vector<double>
      leak_mm2;  ///< by the least surface, of each error; NaN where the closure is not trusted
  /// Error to either side from which on the leak exceeds kTraceLeak_mm2 or no closure is trusted, between two closures by their
  /// difference; 0 if it does as planned.
  double margin_mm = 0.0;
  bool leaks_beyond =
      true;  ///< false: no error that was closed leaks more, and margin_mm is as far as all of them go
};

/// Of each step that can miss, in the order of the plan: up to six closures a curve, which nothing counts or keeps, on all threads.
/// None if the plan's own closure is not kept or not trusted, or if the search was cancelled before.
std::vector<ToleranceCurve> step_tolerances(PlanEvaluations& evaluations, const PlanRecord& plan);

/// Fills margin_mm and leaks_beyond from the other members.
ToleranceCurve with_margin(ToleranceCurve curve);

}  // namespace coapt
