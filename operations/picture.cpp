// Draws a closed valve, repaired if there is a plan, as `coapt close --render` does. Answers a PNG.
#include "io/picture/picture.h"

#include "core/closure/standing.h"
#include "io/picture/opening_picture.h"
#include "operations/export.h"
#include "operations/repair_request.h"
#include "operations/table.h"

namespace coapt {
namespace {

struct PictureRequest {
  RepairRequest repair{};
  bool open = false;
};

Expected<OperationAnswer> draw_picture(const PictureRequest& asked, Context& context) {
  const auto& [before, plan, repaired, material] = asked.repair;
  const Expected<ClosedValve> closed = context.close(repaired);
  if (!closed) return closed.errors();
  std::string diastole;
  if (asked.open) {
    const Expected<OpenedValve> opened = context.open(repaired);
    if (!opened) return opened.errors();
    diastole = opening_line(*opened);
  }
  return OperationAnswer(
      AnswerFile{.type = "image/png",
                 .bytes = closure_picture_png(with_repair(*closed, before, plan), diastole),
                 .closure = closure_name(closed->closure)});
}

}  // namespace

Expected<OperationTask> read_picture(const Json& request, const Context& context) {
  const auto asked = std::make_shared<PictureRequest>();
  if (Errors errors = read_repair(
          request, context, {{"open", into(asked->open, read_boolean), false}}, asked->repair);
      !errors.empty())
    return errors;
  return task_of(asked, asked->open ? 2 : 1, draw_picture);
}

}  // namespace coapt
