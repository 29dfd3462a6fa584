#include "search/plans/drawn_openings.h"

#include <algorithm>
#include <cstddef>
#include <optional>

#include "search/parallel.h"
#include "search/plans/disturbance.h"

namespace coapt {
namespace {

/// A valve to open, and whose it is.
struct Task {
  std::size_t of = 0;
  int draw = -1;   ///< of ModelClosures::distinct
  int error = -1;  ///< else: index of a disturbance
};

void add_evenly(std::vector<Task>& tasks, int count, const auto& task_at) {
  const int most = std::min(count, kDrawnOpenings);
  for (int i = 0; i < most; ++i) tasks.push_back(task_at(i * count / most));
}

std::optional<Valve> valve_of(const PlanEvaluations& evaluations, const PlanRecord* plan,
                              const ModelClosures& model, const Task& task) {
  if (task.draw >= 0)
    return drawn_valve(model.distinct[static_cast<std::size_t>(task.draw)],
                       plan == nullptr ? nullptr : &plan->plan);
  return disturb(evaluations.valve(), evaluations.repaired(*plan), plan->plan,
                 disturbances()[static_cast<std::size_t>(task.error)]);
}

}  // namespace

std::vector<DrawnOpenings> open_under_draws(const PlanEvaluations& evaluations,
                                            const std::vector<const PlanRecord*>& plans,
                                            const ModelClosures& model) {
  std::vector<DrawnOpenings> all(plans.size());
  if (!evaluations.opens()) return all;
  std::vector<Task> tasks;
  for (std::size_t of = 0; of < plans.size(); ++of) {
    const PlanRecord* const plan = plans[of];
    if (plan != nullptr && !(plan->opening && trusted(*plan->opening))) continue;
    if (!model.contradicts && !model.before.empty())
      add_evenly(tasks, static_cast<int>(model.picked.size()), [&](int i) {
        return Task{.of = of, .draw = model.picked[static_cast<std::size_t>(i)]};
      });
    if (plan != nullptr && !plan->plan.steps.empty())
      add_evenly(tasks, kIndependent.count,
                 [&](int i) { return Task{.of = of, .error = kIndependent.first + i}; });
  }
  std::vector<std::optional<PlanOpening>> opened(tasks.size());
  for_each_index(static_cast<int>(tasks.size()), evaluations.threads(), [&](int i) {
    if (evaluations.cancelled()) return;
    const auto at = static_cast<std::size_t>(i);
    const std::optional<Valve> valve = valve_of(evaluations, plans[tasks[at].of], model, tasks[at]);
    if (valve) opened[at] = evaluations.opened(*valve);
  });
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    if (!opened[i]) continue;
    DrawnOpenings& of = all[tasks[i].of];
    (tasks[i].draw >= 0 ? of.draws : of.errors).push_back(*opened[i]);
  }
  return all;
}

}  // namespace coapt
