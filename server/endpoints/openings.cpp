#include "server/endpoints/openings.h"

#include <chrono>

#include "io/json/opening_json.h"
#include "io/json/scene_json.h"
#include "search/plans/gates.h"
#include "server/answers.h"
#include "server/repair_request.h"

namespace coapt {
namespace {

Answer opened_answer(const RepairRequest& asked, RequestClosures& closures,
                     const OpeningOptions& options, int frames) {
  const auto start = std::chrono::steady_clock::now();
  const Expected<OpenedValve> opened = closures.open(asked.repaired, options);
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  if (!opened) {
    ProblemList problems;
    add_below(problems, "/valve", opened.errors());
    return problem(422, std::move(problems).take());
  }
  auto json = opening_to_json(*opened, options, seconds.count());
  json["warnings"] = warnings_of(operation_gates({asked.plan, asked.valve, asked.repaired}));
  json["scene"] = opening_scene_to_json(*opened, frames);
  return json_answer(200, json);
}

}  // namespace

Answer PostOpenings::operator()(const Request& request) const {
  OpeningOptions options;
  int frames = 0;
  const auto read_frames = [](const JsonPlace& place) {
    return read_integer_in(place, 0, kMostFrames);
  };
  const auto number_in = [](double& target, Range range, const char* unit) {
    return into(target, [range, unit](const JsonPlace& place) {
      return read_number_in(place, range, unit);
    });
  };
  return answer_repair(
      valves, compute, request,
      {{"pressure_mmhg", number_in(options.pressure_mmhg, kFillingPressures_mmhg, " mmHg"), false},
       {"flow_ml_s", number_in(options.flow_ml_s, kFillingFlows_ml_s, " ml/s"), false},
       {"exercise", number_in(options.exercise, kExercises, ""), false},
       {"frames", into(frames, read_frames), false}},
      [&](const RepairRequest& asked, RequestClosures& closures) {
        options.motion = frames > 0;
        return opened_answer(asked, closures, options, frames);
      });
}

}  // namespace coapt
