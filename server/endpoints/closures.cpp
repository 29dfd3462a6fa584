#include "server/endpoints/closures.h"

#include <chrono>

#include "io/json/result_json.h"
#include "io/json/scene_json.h"
#include "search/plans/gates.h"
#include "server/answers.h"
#include "server/repair_request.h"

namespace coapt {
namespace {

struct Closed {
  ClosureResult closure;
  nlohmann::ordered_json json;  ///< coapt.closure/1, with the warnings of the operation
};

Closed close(const RepairRequest& asked, RequestClosures& closures, const ClosureOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  Closed closed{closures.close(asked.repaired, options), {}};
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  closed.json = closure_to_json(asked.repaired, closed.closure,
                                measure(asked.repaired, closed.closure), seconds.count());
  closed.json["warnings"] = warnings_of(operation_gates({asked.plan, asked.valve, asked.repaired}));
  return closed;
}

}  // namespace

Answer PostClosures::operator()(const Request& request) const {
  int end_states = 1;
  const auto read_states = [](const JsonPlace& place) {
    return read_integer_in(place, 1, kThesisSamples);
  };
  return answer_repair(
      valves, compute, request, {{"end_states", into(end_states, read_states), false}},
      [&end_states](const RepairRequest& asked, RequestClosures& closures) {
        return json_answer(200, close(asked, closures, {.samples = end_states}).json);
      });
}

Answer PostScenes::operator()(const Request& request) const {
  int frames = 0;
  const auto read_frames = [](const JsonPlace& place) {
    return read_integer_in(place, 0, kMostFrames);
  };
  return answer_repair(
      valves, compute, request, {{"frames", into(frames, read_frames), false}},
      [&frames](const RepairRequest& asked, RequestClosures& closures) {
        Closed closed = close(asked, closures, {.motion = frames > 0});
        auto scene = scene_to_json({asked.repaired, closed.closure, asked.plan, frames});
        scene["closure"] = std::move(closed.json);
        return json_answer(200, std::move(scene));
      });
}

}  // namespace coapt
