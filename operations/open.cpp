// Opens a valve, repaired if there is a plan, under the load of filling. Answers coapt.opening/2.
#include "operations/repair_request.h"
#include "operations/stopwatch.h"
#include "operations/table.h"

namespace coapt {
namespace {

struct OpenRequest {
  RepairRequest repair{};
  OpeningOptions opening{};
  int frames = 0;
};

Expected<OperationAnswer> open(const OpenRequest& asked, Context& context) {
  const Stopwatch watch;
  const Expected<OpenedValve> opened = context.open(asked.repair.repaired, asked.opening);
  if (!opened) return opened.errors();
  Json answer = opening_answer(asked.repair, *opened, asked.frames, watch.seconds());
  if (context.opened) context.opened(*opened);
  return OperationAnswer(std::move(answer));
}

}  // namespace

Expected<OperationTask> read_open(const Json& request, const Context& context) {
  const auto asked = std::make_shared<OpenRequest>();
  std::vector<JsonField> fields = opening_fields(asked->opening);
  fields.push_back(frames_field(asked->frames));
  if (Errors errors = read_repair(request, context, std::move(fields), asked->repair);
      !errors.empty())
    return errors;
  asked->opening.motion = asked->frames > 0;
  return task_of(asked, 1, open);
}

}  // namespace coapt
