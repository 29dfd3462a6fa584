#include "clients/engine/requests.h"

#include <utility>

#include "io/json/parse_json.h"
#include "io/json/problem_json.h"
#include "io/json/version.h"
#include "operations/repair_request.h"

namespace coapt {

EngineAnswer json_answer(int status, Json object, Points closed_mm) {
  object["notice"] = kResearchNotice;
  return {status, json_text(object), std::move(closed_mm)};
}

EngineAnswer problem(int status, const Errors& errors) {
  return json_answer(status, problem_json(status, errors));
}

std::optional<EngineAnswer> read_request(std::string_view body, RepairRequest& asked,
                                         std::vector<JsonField> more) {
  const Expected<Json> json = parse_json(body);
  if (!json) return problem(400, json.errors());
  if (const Errors errors = read_repair(*json, Context{.limits = OperationLimits::unlimited()},
                                        std::move(more), asked);
      !errors.empty())
    return problem(422, errors);
  return std::nullopt;
}

}  // namespace coapt
