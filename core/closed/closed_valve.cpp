#include "core/closed/closed_valve.h"

#include <utility>

namespace coapt {

ClosedValve close_and_measure(const Valve& valve, const ClosureOptions& options) {
  ClosureResult closure = close_valve(valve, options);
  ValveMeasure measured = measure(valve, closure);
  return {valve, std::move(closure), std::move(measured)};
}

ClosedValve with_repair(ClosedValve closed, const Valve& before, const RepairPlan& plan) {
  closed.plan = plan;
  closed.repair = repair_marks(before, closed.valve, plan);
  return closed;
}

}  // namespace coapt
