#include "clients/engine/engine.h"

#include <utility>

#include "clients/engine/requests.h"
#include "io/json/parse_json.h"
#include "io/json/repair_answers.h"
#include "io/json/result_json.h"
#include "io/json/version.h"
#include "operations/valve_operations.h"

namespace coapt {
namespace {

EngineAnswer computed(const Operation& operation, std::string_view body) {
  const Expected<Json> request = parse_json(body);
  if (!request) return problem(400, request.errors());
  Points closed_mm;
  Context context{
      .limits = OperationLimits::unlimited(),  // a page waits for its own engine alone
      .closed = [&](const ClosedValve& closed) { closed_mm = closed.closure.closed_mm; }};
  if (further.searches) context.searches = further.searches;
  const Expected<OperationTask> task = operation.read(*request, context);
  if (!task) return problem(422, task.errors());
  Expected<OperationAnswer> answer = task->run(context);
  if (!answer) return problem(422, answer.errors());
  if (auto* const file = std::get_if<AnswerFile>(&*answer)) return {200, std::move(file->bytes)};
  return json_answer(200, std::get<Json>(*std::move(answer)), std::move(closed_mm));
}

}  // namespace

FurtherOperations further;

EngineAnswer answer(std::string_view path, std::string_view body) {
  const Operation* operation = operation_at(valve_operations(), path);
  if (!operation && further.all) operation = operation_at(further.all(), path);
  if (operation) return computed(*operation, body);
  if (path == "/v1/rings") return json_answer(200, rings_answer());
  if (path == "/version")
    return json_answer(200, {{"version", version()},
                             {"revision", revision_json()},
                             {"farm", false},
                             {"not_modelled", not_modelled()}});
  return problem(404,
                 {Error{ErrorCode::BadReference, "", "needs a service: " + std::string(path)}});
}

}  // namespace coapt
