// Scores and ranks plans of one's own as a search scores its finalists. Answers one of coapt.plans/2 with the plans in the order
// asked, each with its "index" and "rank".
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/valve/counted.h"
#include "io/json/plan_json.h"
#include "io/json/plans_json.h"
#include "operations/repair_request.h"
#include "operations/table.h"
#include "search/plans/plan_key.h"
#include "search/plans/plan_search.h"
#include "search/plans/ranking.h"

namespace coapt {
namespace {

std::vector<RepairPlan> read_plans(const JsonPlace& place) {
  return read_list(place, [](const JsonPlace& entry) {
    RepairPlan plan;
    document(plan, plan_from_json)(entry);
    return plan;
  });
}

/// Ranked plans in the order asked; a plan that was asked for twice twice.
Json in_order(const SearchResult& result, const std::vector<RepairPlan>& asked) {
  const Json json = to_json(result);
  Json plans = Json::array();
  for (std::size_t i = 0; i < asked.size(); ++i) {
    const std::string key = plan_key(asked[i]);
    const auto found = std::find_if(result.plans.begin(), result.plans.end(),
                                    [&](const RankedPlan& r) { return plan_key(r.plan) == key; });
    if (found == result.plans.end()) continue;  // the search was stopped before it
    Json plan = {{"index", i}};
    plan.update(json["plans"][static_cast<std::size_t>(found - result.plans.begin())]);
    plan.erase("name");
    plans.push_back(std::move(plan));
  }
  Json answer = {
      {"version", json["version"]}, {"revision", json["revision"]}, {"before", json["before"]}};
  answer["plans"] = std::move(plans);
  for (const char* name : {"stop", "diagnosis", "any_competent", "verdict", "model_draws",
                           "information", "ladder", "plans_tried", "closures", "closures_known",
                           "closures_not_converged", "closures_crossed", "seconds", "not_modelled"})
    answer[name] = json[name];
  return answer;
}

struct EvaluateRequest {
  Valve valve{};
  std::vector<RepairPlan> plans{};
  SearchOptions options{};
  std::ptrdiff_t closures = 0;  ///< that scoring takes
};

Errors read_asked(const Json& request, const Context& context, EvaluateRequest& asked) {
  SearchOptions& options = asked.options;
  options.threads = context.limits.threads;
  options.evidence = false;
  options.region_points = 1;
  options.fine_levels = 0;
  options.model_draws = 0;
  ProblemList problems;
  const std::vector<JsonField> fields = {
      {"valve", valve_field(context, asked.valve)},
      {"plans", into(asked.plans, read_plans)},
      {"region_points", into(options.region_points, integer_in(1, 1089)), false},
      {"evidence", into(options.evidence, read_boolean), false},
      {"model_draws", into(options.model_draws, integer_in(0, 200)), false}};
  read_fields({request, problems}, fields);
  if (!problems.empty()) return std::move(problems).take();
  const int drawn =
      most_draw_closures(asked.valve, static_cast<int>(asked.plans.size()), options.model_draws);
  asked.closures = std::ssize(asked.plans) * options.region_points + drawn;
  if (options.evidence)
    for (const RepairPlan& plan : asked.plans) asked.closures += evidence_closures(plan);
  const std::ptrdiff_t most = most_closures(asked.valve, context.limits);
  if (asked.closures > most)
    problems.add(ErrorCode::OutOfRange, "/plans",
                 "has " + counted(std::ssize(asked.plans), "plan") + " of " +
                     std::to_string(options.region_points) + " region_points" +
                     (options.evidence ? " and evidence" : "") +
                     (drawn > 0 ? " and model_draws" : "") + ", together " +
                     counted(asked.closures, "closure") + "; must be at most " +
                     std::to_string(most) + " for a valve of this size");
  return std::move(problems).take();
}

Expected<SearchResult> score(const EvaluateRequest& asked, Context& context) {
  SearchOptions options = asked.options;
  // Not in the request: what is asked for again gives the same, however long it may take.
  if (std::isfinite(context.limits.seconds)) options.seconds = context.limits.seconds;
  options.closure.budget.cancelled = [&context] { return context.cancelled(); };
  std::vector<NamedPlan> named;
  for (const RepairPlan& plan : asked.plans) named.push_back({"", plan});
  SearchContext within;
  if (context.searches)
    if (Errors errors = context.searches(asked.valve, options, within); !errors.empty())
      return errors;
  Expected<SearchResult> result = evaluate_plans(asked.valve, named, options, within);
  if (result && context.cancelled()) return context.refusal();
  if (result && context.scored) context.scored(asked.valve, asked.options, *result);
  return result;
}

}  // namespace

Expected<OperationTask> read_evaluate(const Json& request, const Context& context) {
  const auto asked = std::make_shared<EvaluateRequest>();
  if (Errors errors = read_asked(request, context, *asked); !errors.empty()) return errors;
  return OperationTask{asked->valve.rest_mm.rows(), asked->closures,
                       [asked](Context& within) -> Expected<OperationAnswer> {
                         const Expected<SearchResult> result = score(*asked, within);
                         if (!result) return result.errors();
                         return OperationAnswer(in_order(*result, asked->plans));
                       }};
}

}  // namespace coapt
