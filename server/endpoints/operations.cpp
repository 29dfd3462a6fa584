#include "server/endpoints/operations.h"

#include <utility>

#include "server/turns.h"

namespace coapt {

Answer file_answer(AnswerFile file) {
  Answer answer{200, Content{std::move(file.type), std::move(file.bytes)}};
  if (!file.name.empty())
    answer.headers.emplace_back("Content-Disposition", "attachment; filename=\"" + file.name + '"');
  if (!file.closure.empty()) answer.headers.emplace_back("Coapt-Closure", file.closure);
  return answer;
}

Answer PostOperation::operator()(const Request& request) const {
  Context context{
      .limits = operation_limits(valves.limits),
      .valve_named = [this](const std::string& name) { return named_valve(valves, name); },
      .abandoned = request.abandoned};
  context.surface_of = [&](const NamedFile& file, const ShapeFileOptions& options) {
    return read_surface(imports, file, options, context.budget());
  };
  OperationTask task;
  const auto read = [&](const Json& body) {
    Expected<OperationTask> asked = operation.read(body, context);
    if (!asked) return asked.errors();
    task = *std::move(asked);
    return Errors();
  };
  if (auto refused = read_body(valves, request, read)) return *std::move(refused);
  if (auto refused = read_files_in_turn(task, compute, context, request))
    return *std::move(refused);
  const auto run = [&](Context& within) {
    Expected<OperationAnswer> answer = task.run(within);
    if (!answer) return refusal(answer.errors());
    if (auto* const file = std::get_if<AnswerFile>(&*answer)) return file_answer(std::move(*file));
    return json_answer(200, std::get<Json>(*std::move(answer)));
  };
  if (task.closures == 0) return run(context);
  const double seconds = closing_seconds(task.vertices, task.closures) + task.seconds;
  return answer_in_turn(compute, context, turn_for(request, seconds), run);
}

}  // namespace coapt
