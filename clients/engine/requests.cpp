#include "clients/engine/requests.h"

#include <utility>

#include "io/json/parse_json.h"
#include "io/json/plan_json.h"
#include "io/json/problem_json.h"
#include "io/json/valve_json.h"
#include "io/json/version.h"

namespace coapt {

EngineAnswer json_answer(int status, Json object, Points closed_mm) {
  object["notice"] = kResearchNotice;
  return {status, object.dump(-1, ' ', false, Json::error_handler_t::replace),
          std::move(closed_mm)};
}

EngineAnswer problem(int status, const Errors& errors) {
  return json_answer(status, problem_json(status, errors));
}

EngineAnswer problem_below(const std::string& path, const Errors& errors) {
  ProblemList problems;
  add_below(problems, path, errors);
  return problem(422, std::move(problems).take());
}

std::optional<EngineAnswer> read_body(std::string_view body, const std::vector<JsonField>& fields) {
  const Expected<Json> json = parse_json(body);
  if (!json) return problem(400, json.errors());
  ProblemList problems;
  read_fields({*json, problems}, fields);
  if (!problems.empty()) return problem(422, std::move(problems).take());
  return std::nullopt;
}

std::optional<EngineAnswer> read_request(std::string_view body, RepairRequest& asked,
                                         std::vector<JsonField> more) {
  more.insert(more.begin(), {{"valve", document(asked.valve, valve_from_json)},
                             {"plan", document(asked.plan, plan_from_json), false},
                             material_field(asked.material)});
  if (auto refusal = read_body(body, more)) return refusal;
  if (const Errors errors = apply(asked); !errors.empty()) return problem(422, errors);
  return std::nullopt;
}

}  // namespace coapt
