// Closing and measuring one valve: the expensive part of a search, and the part that tests replace.
#pragma once

#include <functional>
#include <memory>

#include "core/closed/closed_valve.h"
#include "core/metrics/measure.h"

namespace coapt {

struct Evaluation {
  ClosureStatus status = ClosureStatus::Converged;
  bool crossing = false;
  ValveMeasure measure;
};

struct ClosedPlan {
  Evaluation evaluation;
  std::shared_ptr<const ClosureResult> closure;  ///< for neighbours to start from; may be null
};

/// Closes and measures a valve, from the closure of a neighbour if there is one (a warm start).
/// Called from several threads at once.
using Evaluator = std::function<ClosedPlan(const Valve&, const ClosureResult* neighbour)>;

/// The same with its leak measured by the least surface, if its closure was kept: closing_evaluator() estimates it.
ClosedPlan with_leak_surface(const Valve& valve, ClosedPlan closed);

/// Of `valve`; null if the evaluator kept no closure.
std::shared_ptr<const ClosedValve> closed_valve(const Valve& valve, const ClosedPlan& closed);

/// What a search closes by: leaks are estimated.
Evaluator closing_evaluator(const ClosureOptions& options, LeakBy leak_by = LeakBy::Estimate);

/// Converged, without leaflets through each other, its leak a number: only then do the measures
/// mean anything.
bool trusted(const Evaluation& evaluation);

}  // namespace coapt
