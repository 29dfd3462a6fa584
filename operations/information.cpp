// Which measurement of a valve would say most of its leak, as it is or repaired. Answers coapt.information/1.
#include "search/studies/information.h"

#include <atomic>

#include "io/json/model_study_json.h"
#include "operations/repair_request.h"
#include "operations/table.h"

namespace coapt {
namespace {

constexpr int kMostDraws = 100'000;

struct InformationRequest {
  RepairRequest repair{};
  ModelStudyOptions study{};
};

Expected<OperationAnswer> inform(const InformationRequest& asked, Context& context) {
  ModelStudyOptions study = asked.study;
  study.threads = context.limits.threads;
  study.evaluate = closing_evaluator({.budget = context.budget()}, LeakBy::Surface);
  if (!asked.repair.plan.steps.empty()) study.unrepaired = &asked.repair.valve;
  std::atomic<bool> over = false;
  study.cancelled = &over;
  study.progress = [&](int done, int planned) {
    over = over || context.cancelled() || (context.interrupted && *context.interrupted);
    if (context.progress) context.progress(done, planned);
  };
  const ModelStudy drawn = study_model(asked.repair.repaired, study);
  if (context.cancelled()) return context.refusal();
  return OperationAnswer(to_json(drawn, information_rows(drawn), asked.repair.valve.name));
}

}  // namespace

Expected<OperationTask> read_information(const Json& request, const Context& context) {
  const auto asked = std::make_shared<InformationRequest>();
  const auto read_draws = [](const JsonPlace& place) {
    return read_integer_in(place, 1, kMostDraws);
  };
  if (Errors errors = read_repair(request, context,
                                  {{"draws", into(asked->study.draws, read_draws), false},
                                   {"seed", into(asked->study.seed, read_unsigned), false}},
                                  asked->repair);
      !errors.empty())
    return errors;
  const bool twice = !asked->repair.plan.steps.empty();
  const int closures = asked->study.draws * (twice ? 2 : 1);
  const std::ptrdiff_t most = most_closures(asked->repair.repaired, context.limits);
  if (closures > most)
    return Error{ErrorCode::OutOfRange, "/draws",
                 "is " + std::to_string(asked->study.draws) + ", together " +
                     std::to_string(closures) + " closures; must be at most " +
                     std::to_string(most / (twice ? 2 : 1)) + " for a valve of this size"};
  return task_of(asked, closures, inform);
}

}  // namespace coapt
