#include "search/plans/fine_closures.h"

#include <array>
#include <limits>
#include <utility>

#include "core/closure/refined_start.h"
#include "core/valve/refine.h"
#include "search/parallel.h"

namespace coapt {
namespace {

/// The refinements of the unrepaired valve that are not too fine, at most so many.
int levels_of(const Valve& valve, int levels) {
  int possible = 0;
  Index triangles = valve.faces.rows();
  Valve finer = valve;
  while (possible < levels && 4 * triangles <= kMostFineTriangles) {
    Expected<Valve> next = refine(finer);
    if (!next) break;
    finer = *std::move(next);
    triangles = finer.faces.rows();
    ++possible;
  }
  return possible;
}

/// Each level from the end of the one before; none if the refined valve is refused.
std::optional<PlanClosure> closed_finely(const PlanEvaluations& evaluations, Valve valve,
                                         ClosedPlan closed, int levels) {
  for (int level = 0; level < levels; ++level) {
    Expected<Valve> finer = refine(valve);
    if (!finer) return std::nullopt;
    ClosureResult start;
    if (closed.closure) start = refined_start(valve, *closed.closure);
    closed = evaluations.evaluate(*finer, closed.closure ? &start : nullptr);
    valve = *std::move(finer);
  }
  return plan_closure(with_leak_surface(valve, std::move(closed)).evaluation);
}

CostTerms nominal_terms(const PlanClosure& closure, const Effort& effort,
                        const CostContext& context) {
  return cost_terms(std::array{ScoredClosure{closure, 0.0}}, effort, context);
}

}  // namespace

FineClosures close_fine(PlanEvaluations& evaluations, const std::vector<PlanRecord*>& plans,
                        int levels, FineClosures known) {
  FineClosures fine = std::move(known);
  fine.mesh.levels = levels_of(evaluations.valve(), levels);
  if (fine.mesh.levels == 0) return fine;
  fine.mesh.triangles = static_cast<int>(evaluations.valve().faces.rows())
                        << (2 * fine.mesh.levels);
  std::vector<const PlanRecord*> missing;
  for (const PlanRecord* plan : plans)
    if (!fine.plans.contains(plan)) missing.push_back(plan);
  if (!fine.mesh.before) missing.push_back(nullptr);  // no repair
  std::vector<std::optional<PlanClosure>> closures(missing.size());
  for_each_index(static_cast<int>(missing.size()), evaluations.threads(), [&](int i) {
    if (evaluations.cancelled()) return;
    const PlanRecord* const plan = missing[i];
    closures[i] = plan == nullptr ? closed_finely(evaluations, evaluations.valve(),
                                                  evaluations.closed_before(), fine.mesh.levels)
                                  : closed_finely(evaluations, evaluations.repaired(*plan),
                                                  evaluations.closed(*plan), fine.mesh.levels);
  });
  for (std::size_t i = 0; i < missing.size(); ++i) {
    if (!closures[i]) continue;
    fine.mesh.closures += fine.mesh.levels;
    if (missing[i] == nullptr)
      fine.mesh.before = closures[i];
    else
      fine.plans.emplace(missing[i], *closures[i]);
  }
  return fine;
}

CostTerms fine_change(const PlanEvaluations& evaluations, const PlanRecord& plan,
                      const FineClosures& fine) {
  const auto closure = fine.plans.find(&plan);
  if (closure == fine.plans.end()) return {};
  CostContext there = evaluations.context();
  there.tension_before_n = fine.mesh.before && trusted(*fine.mesh.before)
                               ? fine.mesh.before->tension_max_n
                               : std::numeric_limits<double>::infinity();
  return {nominal_terms(closure->second, plan.effort, there).amounts -
          nominal_terms(plan.closures.at(0), plan.effort, evaluations.context()).amounts};
}

}  // namespace coapt
