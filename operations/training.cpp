// The trainer (docs/training.md): a case of a seed, the exam of a schedule, the score of a learner.
#include "io/json/schedule_json.h"
#include "io/json/score_json.h"
#include "io/json/training_json.h"
#include "io/json/trials_csv.h"
#include "operations/repair_request.h"
#include "operations/table.h"
#include "search/training/seeds.h"

namespace coapt {
namespace {

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

/// Errors whose paths begin below `path` of the request.
Errors below(const std::string& path, const Errors& errors) {
  ProblemList problems;
  add_below(problems, path, errors);
  return std::move(problems).take();
}

/// The case of a seed with its shapes, or why there is none.
template <class Case>
Expected<OperationAnswer> case_answer(const Expected<Case>& made, const Valve& from) {
  if (!made) return below("/valve", made.errors());
  Json json = to_json(*made, from);
  add_shapes(json, *made);
  return OperationAnswer(std::move(json));
}

struct CaseRequest {
  Valve valve{};
  bool segments = false;
  std::uint64_t seed = 1;
};

struct ExamRequest {
  Schedule schedule{};
  std::uint64_t seed = 1, first_case = 1;
};

Errors problems_of(const Json& request, const std::vector<JsonField>& fields) {
  ProblemList problems;
  read_fields({request, problems}, fields);
  return std::move(problems).take();
}

}  // namespace

Expected<OperationTask> read_training_case(const Json& request, const Context& context) {
  CaseRequest asked;
  const auto is_exam_b = [](const JsonPlace& place) {
    return read_choice(place, {"A", "B"}).value_or(0) == 1;
  };
  if (Errors errors = problems_of(request, {{"valve", valve_field(context, asked.valve)},
                                            {"exam", into(asked.segments, is_exam_b)},
                                            {"seed", into(asked.seed, seed_up_to(kLargestSeed))}});
      !errors.empty())
    return errors;
  return OperationTask{
      asked.valve.rest_mm.rows(), 1, [asked](Context&) {
        return asked.segments ? case_answer(make_exam_b(asked.valve, asked.seed), asked.valve)
                              : case_answer(make_exam_a(asked.valve, asked.seed), asked.valve);
      }};
}

Expected<OperationTask> read_training_exam(const Json& request, const Context& /*context*/) {
  ExamRequest asked;
  if (Errors errors = problems_of(
          request, {{"schedule", document(asked.schedule, schedule_from_json)},
                    {"seed", into(asked.seed, seed_up_to(kLargestSeed))},
                    {"first_case", into(asked.first_case, seed_up_to(kLargestFirstCase)), false}});
      !errors.empty())
    return errors;
  return OperationTask{
      0, 0, [asked](Context&) -> Expected<OperationAnswer> {
        return OperationAnswer(exam_to_json(asked.schedule, asked.seed, asked.first_case));
      }};
}

Expected<OperationTask> read_training_score(const Json& request, const Context& /*context*/) {
  std::string table;
  if (Errors errors = problems_of(request, {{"trials_csv", into(table, read_string)}});
      !errors.empty())
    return errors;
  const Expected<std::vector<TrainingTrial>> trials = read_trials_csv(table);
  if (!trials) return below("/trials_csv", trials.errors());
  return OperationTask{0, 1, [trials = *trials](Context&) -> Expected<OperationAnswer> {
                         return OperationAnswer(score_to_json(trials));
                       }};
}

}  // namespace coapt
