#include "search/plans/start_check.h"

#include <algorithm>

#include "search/parallel.h"

namespace coapt {
std::optional<StartCheck> check_starts(PlanEvaluations& evaluations, const PlanRecord& plan,
                                       int nodes) {
  const int count = std::min(kStartSample, nodes - 1);
  if (count < 1 || evaluations.cancelled() || !evaluations.closed(plan).closure)
    return std::nullopt;
  const Valve repaired = evaluations.repaired(plan);
  std::vector<std::optional<StartCheck>> checks(count);
  for_each_index(count, evaluations.threads(), [&](int i) {
    if (evaluations.cancelled()) return;
    const int node = (i + 1) * (nodes - 1) / count;
    const Valve disturbed = disturb(evaluations.valve(), repaired, plan.plan, disturbances()[node]);
    const ClosedPlan predicted = evaluations.closed(plan, node),
                     cold = evaluations.evaluate(disturbed, nullptr);
    checks[i] = StartCheck{};
    if (trusted(predicted.evaluation) && trusted(cold.evaluation) && predicted.closure &&
        cold.closure)
      checks[i] = compare_ends(
          *predicted.closure, *cold.closure,
          predicted.evaluation.measure.leak.area_mm2 - cold.evaluation.measure.leak.area_mm2);
  });
  std::vector<StartCheck> made;
  for (const std::optional<StartCheck>& check : checks) {
    if (!check) return std::nullopt;
    made.push_back(*check);
  }
  return united(made);
}

}  // namespace coapt
