#include "operations/model_draws.h"

#include <atomic>
#include <string>

#include "search/conditioning.h"
#include "search/threads.h"

namespace coapt {

int draw_closures(const RepairRequest& asked, int draws) {
  const int redrawn = redraws_chordae(asked.valve) ? 1 : 0;  // a closure gives them their lengths
  return ((asked.plan.steps.empty() ? 1 : 2) + redrawn) *
         draw_blocks(asked.valve.observed, draws).draws;
}

Errors check_draws(const RepairRequest& asked, int draws, const Context& context) {
  const int closures = draw_closures(asked, draws);
  const std::ptrdiff_t most = most_closures(asked.repaired, context.limits);
  if (closures <= most) return {};
  return {Error{ErrorCode::OutOfRange, "/draws",
                "is " + std::to_string(draws) + ", together " + std::to_string(closures) +
                    " closures; must be at most " + std::to_string(most * draws / closures) +
                    " for a valve of this size"}};
}

Expected<ModelStudy> study_within(const RepairRequest& asked, ModelStudyOptions study,
                                  ClosureOptions closure, Context& context) {
  study.threads = context.limits.threads;
  closure.budget = context.budget();
  study.evaluate = closing_evaluator(closure, LeakBy::Surface);
  if (!asked.plan.steps.empty()) study.plan = &asked.plan;
  std::atomic<bool> over = false;
  Mutex mutex;
  study.cancelled = [&] {
    if (over) return true;
    const Lock lock(mutex);
    over = over || context.cancelled() || (context.interrupted && *context.interrupted);
    return over.load();
  };
  study.progress = context.progress;
  ModelStudy drawn = study_model(asked.valve, study);
  if (context.cancelled()) return context.refusal();
  return drawn;
}

}  // namespace coapt
