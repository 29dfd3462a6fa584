// The same closure as everything that is drawn of it (scene_json.h); with frames, the way there. Answers coapt.scene/2.
#include "operations/repair_request.h"
#include "operations/stopwatch.h"
#include "operations/table.h"

namespace coapt {
namespace {

struct SceneRequest {
  RepairRequest repair{};
  int frames = 0;
};

Expected<OperationAnswer> draw_scene(const SceneRequest& asked, Context& context) {
  const Stopwatch watch;
  const Expected<ClosedValve> closed =
      context.close(asked.repair.repaired, {.motion = asked.frames > 0});
  if (!closed) return closed.errors();
  Json scene = scene_answer(asked.repair, *closed, asked.frames, watch.seconds());
  if (context.closed) context.closed(*closed);
  return OperationAnswer(std::move(scene));
}

}  // namespace

Expected<OperationTask> read_scene(const Json& request, const Context& context) {
  const auto asked = std::make_shared<SceneRequest>();
  if (Errors errors = read_repair(request, context, {frames_field(asked->frames)}, asked->repair);
      !errors.empty())
    return errors;
  return task_of(asked, 1, draw_scene);
}

}  // namespace coapt
