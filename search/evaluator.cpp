#include "search/evaluator.h"

#include <cmath>

#include "search/prepared_valves.h"

namespace coapt {

Evaluator closing_evaluator(const ClosureOptions& options, LeakBy leak_by) {
  return [options, leak_by, prepared = std::make_shared<PreparedValves>()](
             const Valve& valve, const ClosureResult* neighbour) {
    auto closure = std::make_shared<const ClosureResult>(
        close_valve(*prepared->of(valve, options), valve, options, neighbour));
    const Evaluation evaluation{closure->status, closure->crossing,
                                measure(valve, *closure, leak_by)};
    return ClosedPlan{evaluation, std::move(closure)};
  };
}

ClosedPlan with_leak_surface(const Valve& valve, ClosedPlan closed) {
  if (closed.closure != nullptr)
    closed.evaluation.measure = measure(valve, *closed.closure, LeakBy::Surface);
  return closed;
}

std::shared_ptr<const ClosedValve> closed_valve(const Valve& valve, const ClosedPlan& closed) {
  if (closed.closure == nullptr) return nullptr;
  return std::make_shared<const ClosedValve>(
      ClosedValve{valve, *closed.closure, closed.evaluation.measure});
}

bool trusted(const Evaluation& evaluation) {
  return evaluation.status == ClosureStatus::Converged && !evaluation.crossing &&
         std::isfinite(evaluation.measure.leak.area_mm2);
}

}  // namespace coapt
