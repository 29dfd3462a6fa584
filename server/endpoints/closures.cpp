#include "server/endpoints/closures.h"

#include <algorithm>
#include <chrono>

#include "io/json/plan_json.h"
#include "io/json/plans_json.h"
#include "io/json/result_json.h"
#include "io/json/scene_json.h"
#include "search/plans/gates.h"
#include "search/plans/plan_key.h"
#include "search/plans/plan_search.h"
#include "server/answers.h"

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
constexpr int kMostFrames = 60;
constexpr double kMostSeconds = 60.0;  // of an evaluation: it is waited for

/// How much a closure costs against one of a valve of the usual size, roughly.
double size_of(const Valve& valve) {
  return static_cast<double>(valve.faces.rows()) / kUsualTriangles;
}

/// Ranked plans in the order asked; a plan that was asked for twice twice.
nlohmann::ordered_json in_order(const SearchResult& result, const std::vector<RepairPlan>& asked) {
  const nlohmann::ordered_json json = to_json(result);
  nlohmann::ordered_json plans = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < asked.size(); ++i) {
    const std::string key = plan_key(asked[i]);
    const auto found = std::find_if(result.plans.begin(), result.plans.end(),
                                    [&](const RankedPlan& r) { return plan_key(r.plan) == key; });
    nlohmann::ordered_json plan = {{"index", i}};
    plan.update(json["plans"][static_cast<std::size_t>(found - result.plans.begin())]);
    plan.erase("name");
    plans.push_back(std::move(plan));
  }
  nlohmann::ordered_json answer = {{"version", json["version"]}, {"before", json["before"]}};
  answer["plans"] = std::move(plans);
  for (const char* name : {"any_competent", "ladder", "plans_tried", "closures", "evaluations",
                           "closures_not_converged", "closures_crossed", "seconds", "not_modelled"})
    answer[name] = json[name];
  return answer;
}

/// A valve, and what is done to it.
struct Asked {
  Valve valve;
  RepairPlan plan;
};

struct Closed {
  ClosureResult closure;
  nlohmann::ordered_json json;  ///< coapt.closure/1, with the warnings of the operation
};

Closed close(const Asked& asked, const Valve& repaired, const ClosureOptions& options,
             const std::vector<RingShape>& rings) {
  const auto start = std::chrono::steady_clock::now();
  Closed closed{close_valve(repaired, options), {}};
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  closed.json =
      closure_to_json(repaired, closed.closure, measure(repaired, closed.closure), seconds.count());
  closed.json["warnings"] =
      warnings_of(operation_gates({asked.plan, asked.valve, repaired, rings}));
  return closed;
}

}  // namespace

Answer PostClosures::operator()(const Request& request) const {
  Asked asked;
  if (auto refused = read_body(valves.parsing, request.body,
                               {{"valve", valve_field(valves, asked.valve)},
                                {"plan", document(asked.plan, plan_from_json), false}}))
    return *std::move(refused);
  const Expected<Valve> repaired = repaired_valve(asked.valve, asked.plan, rings);
  if (!repaired) return problem(422, repaired.errors());
  const Compute::Turn turn(compute);
  if (!turn) return too_busy();
  return json_answer(200, close(asked, *repaired, {.samples = kThesisSamples}, rings).json);
}

Answer PostScenes::operator()(const Request& request) const {
  Asked asked;
  int frames = 0;
  const auto read_frames = [](const JsonPlace& place) {
    return read_integer_in(place, 0, kMostFrames);
  };
  if (auto refused = read_body(valves.parsing, request.body,
                               {{"valve", valve_field(valves, asked.valve)},
                                {"plan", document(asked.plan, plan_from_json), false},
                                {"frames", into(frames, read_frames), false}}))
    return *std::move(refused);
  const Expected<Valve> repaired = repaired_valve(asked.valve, asked.plan, rings);
  if (!repaired) return problem(422, repaired.errors());
  const Compute::Turn turn(compute);
  if (!turn) return too_busy();
  Closed closed = close(asked, *repaired, {.motion = frames > 0}, rings);
  auto scene = scene_to_json({*repaired, closed.closure, asked.plan, frames});
  scene["closure"] = std::move(closed.json);
  return json_answer(200, std::move(scene));
}

Answer PostEvaluations::operator()(const Request& request) const {
  Valve valve;
  std::vector<RepairPlan> plans;
  SearchOptions options;
  options.threads = 1;
  options.evidence = false;
  options.region_points = 1;
  options.seconds = kMostSeconds;
  const auto points = [](const JsonPlace& place) { return read_integer_in(place, 1, 1089); };
  if (auto refused = read_body(valves.parsing, request.body,
                               {{"valve", valve_field(valves, valve)},
                                {"plans", into(plans, read_plans)},
                                {"region_points", into(options.region_points, points), false}}))
    return *std::move(refused);
  ProblemList problems;
  const std::ptrdiff_t closures = std::ssize(plans) * options.region_points;
  const auto most = static_cast<std::ptrdiff_t>(valves.limits.evaluation_closures /
                                                std::max(1.0, size_of(valve)));
  if (closures > most)
    problems.add(ErrorCode::OutOfRange, "/plans",
                 "has " + std::to_string(plans.size()) + " plans of " +
                     std::to_string(options.region_points) + " region_points, together " +
                     std::to_string(closures) + " closures; must be at most " +
                     std::to_string(most) + " for a valve of this size");
  if (!problems.empty()) return problem(422, std::move(problems).take());

  std::vector<NamedPlan> named;
  for (const RepairPlan& plan : plans) named.push_back({"", plan});
  const Compute::Turn turn(compute);
  if (!turn) return too_busy();
  const Expected<SearchResult> result = evaluate_plans(valve, named, options, {.catalogue = rings});
  if (!result) return problem(422, result.errors());
  if (result->stop == SearchStop::TimeLimit)
    return retry_later(503, "took longer than " + shown(kMostSeconds) +
                                " s: ask for fewer plans or region_points at once");
  return json_answer(200, in_order(*result, plans));
}

}  // namespace coapt
