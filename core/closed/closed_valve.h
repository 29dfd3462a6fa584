// A valve with its closure, what is measured of it, and how it was repaired: what is drawn, exported and reported.
#pragma once

#include "core/closure/closure.h"
#include "core/metrics/measure.h"
#include "core/repair/plan.h"
#include "core/repair/repair_marks.h"

namespace coapt {

struct ClosedValve {
  Valve valve;  ///< as it was closed: repaired, if it was
  ClosureResult closure;
  ValveMeasure measure;
  RepairPlan plan{};     ///< by which it was repaired; no steps: it was not
  RepairMarks repair{};  ///< what the plan put into it
};

/// Closes and measures a valve as it is; repair it before (apply_plan.h). Deterministic. The measures of a closure that did not
/// converge, or whose leaflets cross, do not count: ClosureResult says so.
/// @pre validate(valve) is empty.
ClosedValve close_and_measure(const Valve& valve, const ClosureOptions& options = {});

/// The closed valve with the plan that made it from `before`.
ClosedValve with_repair(ClosedValve closed, const Valve& before, const RepairPlan& plan);

}  // namespace coapt
