#include "server/endpoints/closures.h"

#include <chrono>

#include "server/answers.h"
#include "server/repair_request.h"

namespace coapt {
namespace {

struct Closed {
  ClosureResult closure;
  double seconds = 0.0;
};

Closed close(const RepairRequest& asked, RequestClosures& closures, const ClosureOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  Closed closed{closures.close(asked.repaired, options)};
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  closed.seconds = seconds.count();
  return closed;
}

}  // namespace

Answer PostClosures::operator()(const Request& request) const {
  return answer_repair(
      valves, compute, request, {}, [](const RepairRequest& asked, RequestClosures& closures) {
        const Closed closed = close(asked, closures, {});
        return json_answer(200, closure_answer(asked, closed.closure, closed.seconds));
      });
}

Answer PostScenes::operator()(const Request& request) const {
  int frames = 0;
  return answer_repair(valves, compute, request, {frames_field(frames)},
                       [&frames](const RepairRequest& asked, RequestClosures& closures) {
                         const Closed closed = close(asked, closures, {.motion = frames > 0});
                         return json_answer(
                             200, scene_answer(asked, closed.closure, frames, closed.seconds));
                       });
}

}  // namespace coapt
