#include "search/evaluator.h"

#include <cmath>

#include "search/prepared_valves.h"

namespace coapt {

Evaluator closing_evaluator(const ClosureOptions& options) {
  return [options, prepared = std::make_shared<PreparedValves>()](const Valve& valve,
                                                                  const ClosureResult* neighbour) {
    auto closure = std::make_shared<const ClosureResult>(
        close_valve(*prepared->of(valve, options), valve, options, neighbour));
    const Evaluation evaluation{closure->status, closure->crossing, measure(valve, *closure)};
    return ClosedPlan{evaluation, std::move(closure)};
  };
}

std::shared_ptr<const ClosedValve> closed_valve(const Valve& valve, const ClosedPlan& closed) {
  if (closed.closure == nullptr) return nullptr;
  return std::make_shared<const ClosedValve>(
      ClosedValve{valve, *closed.closure, closed.evaluation.measure});
}

bool trusted(const Evaluation& evaluation) {
  return evaluation.status == ClosureStatus::Converged && !evaluation.crossing &&
         std::isfinite(leak_mm2(evaluation.measure));
}

}  // namespace coapt
