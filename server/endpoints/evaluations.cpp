#include "server/endpoints/evaluations.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <variant>

#include "io/json/plan_json.h"
#include "io/json/plans_json.h"
#include "io/picture/report.h"
#include "io/store/subject.h"
#include "search/plans/plan_key.h"
#include "search/plans/plan_search.h"
#include "search/plans/ranking.h"
#include "server/answers.h"
#include "server/request_closures.h"

namespace coapt {
namespace {

std::vector<RepairPlan> read_plans(const JsonPlace& place) {
  return read_list(place, [](const JsonPlace& entry) {
    RepairPlan plan;
    document(plan, plan_from_json)(entry);
    return plan;
  });
}

constexpr double kUsualTriangles = 650.0;
constexpr std::size_t kMostReported = 10, kAnyNumber = std::numeric_limits<std::size_t>::max();

/// How much a closure costs against one of a valve of the usual size, roughly.
double size_of(const Valve& valve) {
  return static_cast<double>(valve.faces.rows()) / kUsualTriangles;
}

/// Ranked plans in the order asked; a plan that was asked for twice twice.
Json in_order(const SearchResult& result, const std::vector<RepairPlan>& asked) {
  const Json json = to_json(result);
  Json plans = Json::array();
  for (std::size_t i = 0; i < asked.size(); ++i) {
    const std::string key = plan_key(asked[i]);
    const auto found = std::find_if(result.plans.begin(), result.plans.end(),
                                    [&](const RankedPlan& r) { return plan_key(r.plan) == key; });
    Json plan = {{"index", i}};
    plan.update(json["plans"][static_cast<std::size_t>(found - result.plans.begin())]);
    plan.erase("name");
    plans.push_back(std::move(plan));
  }
  Json answer = {
      {"version", json["version"]}, {"revision", json["revision"]}, {"before", json["before"]}};
  answer["plans"] = std::move(plans);
  for (const char* name :
       {"diagnosis", "any_competent", "verdict", "model_draws", "ladder", "plans_tried", "closures",
        "closures_not_converged", "closures_crossed", "seconds", "not_modelled"})
    answer[name] = json[name];
  return answer;
}

struct AskedPlans {
  Valve valve;
  std::vector<RepairPlan> plans;
  SearchOptions options;
  TurnCost cost = TurnCost::Long;
};

std::variant<AskedPlans, Answer> read_asked(const ValveSource& valves, const Request& request,
                                            std::size_t most_plans) {
  AskedPlans asked;
  asked.options.threads = valves.limits.request_threads;
  asked.options.evidence = false;
  asked.options.region_points = 1;
  asked.options.fine_levels = 0;
  asked.options.model_draws = 0;
  asked.options.seconds = valves.limits.request_seconds;
  const auto points = [](const JsonPlace& place) { return read_integer_in(place, 1, 1089); };
  const auto draws = [](const JsonPlace& place) { return read_integer_in(place, 0, 200); };
  if (auto refused = read_body(valves, request.body,
                               {{"valve", valve_field(valves, asked.valve)},
                                {"plans", into(asked.plans, read_plans)},
                                {"region_points", into(asked.options.region_points, points), false},
                                {"evidence", into(asked.options.evidence, read_boolean), false},
                                {"model_draws", into(asked.options.model_draws, draws), false}}))
    return *std::move(refused);
  ProblemList problems;
  const std::string count = "has " + std::to_string(asked.plans.size()) + " plans";
  if (asked.plans.size() > most_plans)
    problems.add(ErrorCode::OutOfRange, "/plans",
                 count + "; must be at most " + std::to_string(most_plans));
  const int drawn = most_draw_closures(asked.valve, static_cast<int>(asked.plans.size()),
                                       asked.options.model_draws);
  std::ptrdiff_t closures = std::ssize(asked.plans) * asked.options.region_points + drawn;
  if (asked.options.evidence)
    for (const RepairPlan& plan : asked.plans) closures += evidence_closures(plan);
  const auto most = static_cast<std::ptrdiff_t>(valves.limits.evaluation_closures /
                                                std::max(1.0, size_of(asked.valve)));
  if (closures > most)
    problems.add(ErrorCode::OutOfRange, "/plans",
                 count + " of " + std::to_string(asked.options.region_points) + " region_points" +
                     (asked.options.evidence ? " and evidence" : "") +
                     (drawn > 0 ? " and model_draws" : "") + ", together " +
                     std::to_string(closures) + " closures; must be at most " +
                     std::to_string(most) + " for a valve of this size");
  if (!problems.empty()) return problem(422, std::move(problems).take());
  asked.cost = cost_of(asked.valve, closures);
  return asked;
}

std::variant<SearchResult, Answer> score(AskedPlans asked, RequestClosures& closures) {
  asked.options.closure.budget.cancelled = [&closures] { return closures.cancelled(); };
  std::vector<NamedPlan> named;
  for (const RepairPlan& plan : asked.plans) named.push_back({"", plan});
  const Expected<SearchResult> result = evaluate_plans(asked.valve, named, asked.options, {});
  if (!result) return problem(422, result.errors());
  if (closures.cancelled()) return closures.refusal();
  return *result;
}

/// `answer(asked, result)` for what `request` asks, or what stands in the way.
template <class Write>
Answer scored(const ValveSource& valves, Compute& compute, const Request& request,
              std::size_t most_plans, const Write& write) {
  const auto asked = read_asked(valves, request, most_plans);
  if (const auto* refused = std::get_if<Answer>(&asked)) return *refused;
  return answer_in_turn(compute, valves.limits, request, std::get<AskedPlans>(asked).cost,
                        [&](RequestClosures& closures) -> Answer {
                          const auto result = score(std::get<AskedPlans>(asked), closures);
                          if (const auto* refused = std::get_if<Answer>(&result)) return *refused;
                          return write(std::get<AskedPlans>(asked), std::get<SearchResult>(result));
                        });
}

}  // namespace

Answer PostEvaluations::operator()(const Request& request) const {
  return scored(valves, compute, request, kAnyNumber,
                [](const AskedPlans& asked, const SearchResult& result) {
                  return json_answer(200, in_order(result, asked.plans));
                });
}

Answer PostReports::operator()(const Request& request) const {
  return scored(
      valves, compute, request, kMostReported,
      [](const AskedPlans& asked, const SearchResult& result) {
        const SearchRequest as{asked.options, subject_of(asked.valve, asked.options.closure), ""};
        return Answer{200, Content{kHtmlType, plan_report_html(result, as)}};
      });
}

}  // namespace coapt
