#include "server/endpoints/closures.h"

#include <chrono>

#include "io/json/plan_json.h"
#include "io/json/result_json.h"
#include "io/json/scene_json.h"
#include "search/plans/gates.h"
#include "server/answers.h"

namespace coapt {
namespace {

constexpr int kMostFrames = 60;

/// A valve, and what is done to it.
struct Asked {
  Valve valve;
  RepairPlan plan;
};

struct Closed {
  ClosureResult closure;
  nlohmann::ordered_json json;  ///< coapt.closure/1, with the warnings of the operation
};

Closed close(const Asked& asked, const Valve& repaired, const ClosureOptions& options,
             const std::vector<RingShape>& rings) {
  const auto start = std::chrono::steady_clock::now();
  Closed closed{close_valve(repaired, options), {}};
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  closed.json =
      closure_to_json(repaired, closed.closure, measure(repaired, closed.closure), seconds.count());
  closed.json["warnings"] =
      warnings_of(operation_gates({asked.plan, asked.valve, repaired, rings}));
  return closed;
}

}  // namespace

Answer PostClosures::operator()(const Request& request) const {
  Asked asked;
  if (auto refused = read_body(valves.parsing, request.body,
                               {{"valve", valve_field(valves, asked.valve)},
                                {"plan", document(asked.plan, plan_from_json), false}}))
    return *std::move(refused);
  const Expected<Valve> repaired = repaired_valve(asked.valve, asked.plan, rings);
  if (!repaired) return problem(422, repaired.errors());
  const Compute::Turn turn(compute);
  if (!turn) return too_busy();
  return json_answer(200, close(asked, *repaired, {.samples = kThesisSamples}, rings).json);
}

Answer PostScenes::operator()(const Request& request) const {
  Asked asked;
  int frames = 0;
  const auto read_frames = [](const JsonPlace& place) {
    return read_integer_in(place, 0, kMostFrames);
  };
  if (auto refused = read_body(valves.parsing, request.body,
                               {{"valve", valve_field(valves, asked.valve)},
                                {"plan", document(asked.plan, plan_from_json), false},
                                {"frames", into(frames, read_frames), false}}))
    return *std::move(refused);
  const Expected<Valve> repaired = repaired_valve(asked.valve, asked.plan, rings);
  if (!repaired) return problem(422, repaired.errors());
  const Compute::Turn turn(compute);
  if (!turn) return too_busy();
  Closed closed = close(asked, *repaired, {.motion = frames > 0}, rings);
  auto scene = scene_to_json({*repaired, closed.closure, asked.plan, frames});
  scene["closure"] = std::move(closed.json);
  return json_answer(200, std::move(scene));
}

}  // namespace coapt
