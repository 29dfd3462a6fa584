#include "server/repair_request.h"

#include "io/json/plan_json.h"

namespace coapt {

std::variant<RepairRequest, Answer> read_repair_request(const ValveSource& valves,
                                                        std::string_view body,
                                                        std::vector<JsonField> more) {
  RepairRequest asked;
  more.insert(more.begin(), {{"valve", valve_field(valves, asked.valve)},
                             {"plan", document(asked.plan, plan_from_json), false},
                             material_field(asked.material)});
  if (auto refused = read_body(valves, body, more)) return *std::move(refused);
  if (const Errors errors = apply(asked); !errors.empty()) return problem(422, errors);
  return asked;
}

}  // namespace coapt
