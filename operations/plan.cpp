// Searches for repair plans and ranks them. Answers coapt.plans/2.
#include <cmath>
#include <limits>

#include "io/json/plans_json.h"
#include "io/json/search_options_json.h"
#include "io/json/subject.h"
#include "operations/repair_request.h"
#include "operations/table.h"

namespace coapt {
namespace {

struct PlanRequest {
  Valve valve{};
  SearchOptions options{};
};

Expected<OperationAnswer> search(const PlanRequest& asked, Context& context) {
  SearchOptions options = asked.options;
  if (context.limits.threads > 0) options.threads = context.limits.threads;
  if (std::isfinite(context.limits.seconds))
    options.seconds = options.seconds > 0.0 ? std::min(options.seconds, context.limits.seconds)
                                            : context.limits.seconds;
  options.closure.budget = context.budget();
  SearchContext within{.cancelled = context.interrupted};
  if (context.progress)
    within.progress = [&](const SearchProgress& progress) {
      context.progress(progress.closures, progress.closures_planned);
    };
  if (context.searches)
    if (Errors errors = context.searches(asked.valve, options, within); !errors.empty())
      return errors;
  const Expected<SearchResult> result = search_plans(asked.valve, options, within);
  if (!result) return result.errors();
  if (context.cancelled()) return context.refusal();
  if (context.scored) context.scored(asked.valve, asked.options, *result);
  const SearchRequest reproduce{asked.options, subject_of(asked.valve, asked.options.closure), ""};
  return OperationAnswer(to_json(*result, reproduce));
}

}  // namespace

Expected<OperationTask> read_plan(const Json& request, const Context& context) {
  const auto asked = std::make_shared<PlanRequest>();
  ProblemList problems;
  read_fields({request, problems},
              {{"valve", valve_field(context, asked->valve)},
               {"search", document(asked->options, search_options_from_json), false}});
  if (problems.empty()) add_below(problems, "/search", check_search(asked->valve, asked->options));
  if (!problems.empty()) return std::move(problems).take();
  return OperationTask{asked->valve.rest_mm.rows(), std::numeric_limits<std::ptrdiff_t>::max(),
                       [asked](Context& within) { return search(*asked, within); }};
}

}  // namespace coapt
