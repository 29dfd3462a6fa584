#include "server/jobs/operation_job.h"

#include <algorithm>

#include "io/json/parse_json.h"
#include "operations/operations.h"
#include "server/jobs/closure_keeping.h"
#include "server/turns.h"

namespace coapt {

std::optional<JobEnd> OperationJob::operator()(RunningJob& job) const {
  using Text = std::optional<std::string>;
  const Text body = retried<Text>(board, job, [&] { return store.input(job.job.id); });
  if (!body) return failed(job, {Error{ErrorCode::BadReference, "", "its input no longer exists"}});
  const Expected<Json> request = parse_json(*body);
  if (!request) return failed(job, request.errors());
  if (const std::optional<JobEnd> end = begin(board, job, 0)) return end;

  Context context{.limits = operation_limits(reader.limits),
                  .valve_named = [&](const std::string&) { return valve_of(store, job.job); },
                  .abandoned = [&] { return board.stopping(); },
                  .interrupted = &job.cancelled};
  context.limits.vertex_steps = std::numeric_limits<double>::infinity();
  context.limits.threads = reader.limits.threads;
  context.limits.seconds = std::max(0.0, reader.limits.seconds - job.seconds());
  context.surface_of = [&](const NamedFile& file, const ShapeFileOptions& options) {
    return read_surface(reader, file, options, context.budget());
  };
  JobProgress progress{.stage = operation.name};
  job.note(progress);
  context.distance = [&](double rms_mm) { progress.rms_mm = rms_mm; };
  context.progress = [&](int done, int planned) {
    progress.closures = done;
    progress.closures_planned = planned;
    job.note(progress);
  };
  const Expected<OperationTask> task = operation.read(*request, context);
  if (!task) return failed(job, task.errors());
  context.start();
  const Expected<OperationAnswer> answer = task->run(context);
  if (board.stopping()) return std::nullopt;
  if (!answer) return failed(job, answer.errors());
  JobEnd end = ended(job, job.cancel_asked ? JobState::Cancelled : JobState::Succeeded);
  end.summary = Json::object().dump();
  end.result = std::get<Json>(*answer).dump();
  return end;
}

std::map<std::string, JobWork> with_operations(std::map<std::string, JobWork> works,
                                               JobBoard& board, JobStore& store,
                                               const ImportReader& reader) {
  for (const Operation& operation : operations())
    if (operation.as_job)
      works.emplace(operation.name, OperationJob{operation, board, store, reader});
  return works;
}

}  // namespace coapt
