#include "clients/engine/engine.h"

#include <chrono>
#include <utility>

#include "clients/engine/requests.h"
#include "core/closure/closure.h"
#include "io/json/repair_answers.h"
#include "io/json/result_json.h"
#include "io/json/valve_json.h"

namespace coapt {
namespace {

class Stopwatch {
 public:
  double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

EngineAnswer closed(std::string_view body) {
  RepairRequest asked;
  if (auto refusal = read_request(body, asked, {})) return *std::move(refusal);
  const Stopwatch watch;
  const ClosureResult closure = close_valve(asked.repaired, {});
  return json_answer(200, closure_answer(asked, closure, watch.seconds()), closure.closed_mm);
}

EngineAnswer drawn(std::string_view body) {
  RepairRequest asked;
  int frames = 0;
  if (auto refusal = read_request(body, asked, {frames_field(frames)})) return *std::move(refusal);
  const Stopwatch watch;
  const ClosureResult closure = close_valve(asked.repaired, {.motion = frames > 0});
  return json_answer(200, scene_answer(asked, closure, frames, watch.seconds()), closure.closed_mm);
}

EngineAnswer opened(std::string_view body) {
  RepairRequest asked;
  OpeningOptions options;
  int frames = 0;
  std::vector<JsonField> fields = opening_fields(options);
  fields.push_back(frames_field(frames));
  if (auto refusal = read_request(body, asked, std::move(fields))) return *std::move(refusal);
  options.motion = frames > 0;
  const Stopwatch watch;
  const Expected<OpenedValve> opened = open_valve(asked.repaired, options);
  if (!opened) {
    ProblemList problems;
    add_below(problems, "/valve", opened.errors());
    return problem(422, std::move(problems).take());
  }
  return json_answer(200, opening_answer(asked, *opened, options, frames, watch.seconds()));
}

EngineAnswer validated(std::string_view body) {
  const Expected<Valve> valve = read_valve(body);
  return json_answer(200, {{"valid", static_cast<bool>(valve)},
                           {"problems", to_json(valve ? Errors{} : valve.errors())}});
}

}  // namespace

EngineAnswer answer(std::string_view path, std::string_view body) {
  if (path == "/v1/closures") return closed(body);
  if (path == "/v1/scenes") return drawn(body);
  if (path == "/v1/openings") return opened(body);
  if (path == "/v1/valves:validate") return validated(body);
  if (path == "/v1/rings") return json_answer(200, rings_answer());
  if (path == "/version")
    return json_answer(200, {{"version", version()}, {"not_modelled", not_modelled()}});
  return problem(404,
                 {Error{ErrorCode::BadReference, "", "needs a service: " + std::string(path)}});
}

}  // namespace coapt
