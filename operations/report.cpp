// The report on plans of one's own, which are scored as by evaluate: one HTML page.
#include "io/picture/report.h"

#include <utility>

#include "io/json/subject.h"
#include "operations/table.h"

namespace coapt {
namespace {

constexpr std::size_t kMostReported = 10;

}  // namespace

Expected<OperationTask> read_report(const Json& request, const Context& context) {
  Expected<OperationTask> task = read_evaluate(request, context);
  if (!task) return task.errors();
  if (const std::size_t plans = request["plans"].size(); plans > kMostReported)
    return Error{ErrorCode::OutOfRange, "/plans",
                 "has " + std::to_string(plans) + " plans; must be at most " +
                     std::to_string(kMostReported)};
  task->run = [evaluate = std::move(task->run)](Context& within) -> Expected<OperationAnswer> {
    AnswerFile report{"text/html; charset=utf-8", ""};
    within.scored = [&](const Valve& valve, const SearchOptions& options,
                        const SearchResult& result) {
      report.bytes = plan_report_html(result, {options, subject_of(valve, options.closure), ""});
    };
    const Expected<OperationAnswer> scored = evaluate(within);
    within.scored = {};
    if (!scored) return scored.errors();
    return OperationAnswer(std::move(report));
  };
  return task;
}

}  // namespace coapt
