#include "core/closed/close_refined.h"

#include <utility>

#include "core/closure/refined_start.h"
#include "core/valve/refine.h"

namespace coapt {

std::optional<ClosedValve> close_refined(const ClosedValve& closed, const ClosureOptions& options,
                                         int most_vertices) {
  Expected<Valve> finer = refine(closed.valve);
  if (!finer || finer->rest_mm.rows() > most_vertices) return std::nullopt;
  const ClosureResult start = refined_start(closed.valve, closed.closure);
  ClosureResult closure = close_valve(*finer, options, &start);
  ValveMeasure measured = measure(*finer, closure);
  return ClosedValve{*std::move(finer), std::move(closure), std::move(measured)};
}

}  // namespace coapt
