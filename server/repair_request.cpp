#include "server/repair_request.h"

#include "core/repair/apply_plan.h"
#include "io/json/plan_json.h"

namespace coapt {

std::variant<RepairRequest, Answer> read_repair_request(const ValveSource& valves,
                                                        std::string_view body,
                                                        std::vector<JsonField> more) {
  RepairRequest asked;
  more.insert(more.begin(), {{"valve", valve_field(valves, asked.valve)},
                             {"plan", document(asked.plan, plan_from_json), false}});
  if (auto refused = read_body(valves, body, more)) return *std::move(refused);
  Expected<Valve> repaired = apply_plan(asked.valve, asked.plan);
  if (!repaired) {
    ProblemList problems;
    add_below(problems, "/plan", repaired.errors());
    return problem(422, std::move(problems).take());
  }
  asked.repaired = *std::move(repaired);
  return asked;
}

}  // namespace coapt
