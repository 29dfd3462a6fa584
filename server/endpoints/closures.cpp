#include "server/endpoints/closures.h"

#include <chrono>

#include "core/repair/apply_plan.h"
#include "io/json/plan_json.h"
#include "io/json/result_json.h"
#include "io/json/valve_json.h"
#include "search/plans/gates.h"
#include "server/request.h"

namespace coapt {

Answer PostClosures::operator()(std::string_view body) const {
  const Expected<nlohmann::json> request = parse_json(body);
  if (!request) return problem(400, request.errors());
  Valve valve;
  RepairPlan plan;
  ProblemList problems;
  read_fields({*request, problems}, {{"valve", document(valve, valve_from_json)},
                                     {"plan", document(plan, plan_from_json), false}});
  if (!problems.empty()) return problem(422, std::move(problems).take());
  const Expected<Valve> repaired = apply_plan(valve, plan, catalogue);
  if (!repaired) {
    add_below(problems, "/plan", repaired.errors());
    return problem(422, std::move(problems).take());
  }

  const auto start = std::chrono::steady_clock::now();
  const ClosureResult closure = close_valve(*repaired, {.samples = kThesisSamples});
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  auto json = closure_to_json(*repaired, closure, measure(*repaired, closure), seconds.count());
  json["warnings"] = warnings_of(operation_gates({plan, valve, *repaired, catalogue}));
  return {200, std::move(json)};
}

}  // namespace coapt
