#include "clients/engine/engine.h"

#include <chrono>
#include <utility>

#include "clients/engine/requests.h"
#include "core/closure/closure.h"
#include "io/json/repair_answers.h"
#include "io/json/result_json.h"
#include "io/json/schedule_json.h"
#include "io/json/score_json.h"
#include "io/json/training_json.h"
#include "io/json/trials_csv.h"
#include "io/json/valve_json.h"
#include "io/json/version.h"
#include "search/training/seeds.h"

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
  if (!opened) return problem_below("/valve", opened.errors());
  return json_answer(200, opening_answer(asked, *opened, frames, watch.seconds()));
}

EngineAnswer validated(std::string_view body) {
  const Expected<Valve> valve = read_valve(body);
  return json_answer(200, {{"valid", static_cast<bool>(valve)},
                           {"problems", to_json(valve ? Errors{} : valve.errors())}});
}

auto seed_up_to(std::uint64_t most) {
  return [most](const JsonPlace& place) -> std::uint64_t {
    if (!place.value.is_number_integer()) return read_unsigned(place);
    if (place.value.is_number_unsigned() && place.value.get<std::uint64_t>() <= most)
      return place.value.get<std::uint64_t>();
    add_problem(place, ErrorCode::OutOfRange,
                "is " + place.value.dump() + ", must be from 0 to " + std::to_string(most));
    return 0;
  };
}

/// The case of a seed with its shapes, or why there is none.
template <class Case>
EngineAnswer case_answer(const Expected<Case>& made, const Valve& from) {
  if (!made) return problem_below("/valve", made.errors());
  Json json = to_json(*made, from);
  add_shapes(json, *made);
  return json_answer(200, std::move(json));
}

EngineAnswer training_case(std::string_view body) {
  Valve valve;
  bool segments = false;
  std::uint64_t seed = 1;
  if (auto refusal =
          read_body(body, {{"valve", document(valve, valve_from_json)},
                           {"exam", into(segments,
                                         [](const JsonPlace& place) {
                                           return read_choice(place, {"A", "B"}).value_or(0) == 1;
                                         })},
                           {"seed", into(seed, seed_up_to(kLargestSeed))}}))
    return *std::move(refusal);
  return segments ? case_answer(make_exam_b(valve, seed), valve)
                  : case_answer(make_exam_a(valve, seed), valve);
}

EngineAnswer training_exam(std::string_view body) {
  Schedule schedule;
  std::uint64_t seed = 1, first_case = 1;
  if (auto refusal =
          read_body(body, {{"schedule", document(schedule, schedule_from_json)},
                           {"seed", into(seed, seed_up_to(kLargestSeed))},
                           {"first_case", into(first_case, seed_up_to(kLargestFirstCase)), false}}))
    return *std::move(refusal);
  return json_answer(200, exam_to_json(schedule, seed, first_case));
}

EngineAnswer training_score(std::string_view body) {
  std::string table;
  if (auto refusal = read_body(body, {{"trials_csv", into(table, read_string)}}))
    return *std::move(refusal);
  const Expected<std::vector<TrainingTrial>> trials = read_trials_csv(table);
  if (!trials) return problem_below("/trials_csv", trials.errors());
  return json_answer(200, score_to_json(*trials));
}

}  // namespace

EngineAnswer answer(std::string_view path, std::string_view body) {
  if (path == "/v1/closures") return closed(body);
  if (path == "/v1/scenes") return drawn(body);
  if (path == "/v1/openings") return opened(body);
  if (path == "/v1/valves:validate") return validated(body);
  if (path == "/v1/training/cases") return training_case(body);
  if (path == "/v1/training/exams") return training_exam(body);
  if (path == "/v1/training/scores") return training_score(body);
  if (path == "/v1/rings") return json_answer(200, rings_answer());
  if (path == "/version")
    return json_answer(200, {{"version", version()},
                             {"revision", revision_json()},
                             {"farm", false},
                             {"not_modelled", not_modelled()}});
  return problem(404,
                 {Error{ErrorCode::BadReference, "", "needs a service: " + std::string(path)}});
}

}  // namespace coapt
