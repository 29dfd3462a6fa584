#include "search/evaluator.h"

#include <cmath>

namespace coapt {

Evaluator closing_evaluator(const ClosureOptions& options) {
  return [options](const Valve& valve) {
    const ClosureResult closure = close_valve(valve, options);
    return Evaluation{closure.status, closure.crossing, measure(valve, closure)};
  };
}

bool trusted(const ClosureResult& closure) {
  return closure.status == ClosureStatus::Converged && !closure.crossing;
}

bool trusted(const Evaluation& evaluation) {
  return evaluation.status == ClosureStatus::Converged && !evaluation.crossing &&
         std::isfinite(leak_mm2(evaluation.measure));
}

}  // namespace coapt
