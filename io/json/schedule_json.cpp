#include "io/json/schedule_json.h"

#include <utility>

#include "io/json/json_reader.h"
#include "io/json/parse_json.h"
#include "io/json/result_json.h"
#include "io/json/version.h"

namespace coapt {
namespace {

constexpr int kMostCases = 100, kMostSeconds = 3600;
constexpr std::size_t kMostBlocks = 50, kLongestBlockName = 64;

std::string read_block_name(const JsonPlace& place) {
  std::string name = read_string(place);
  if (place.value.is_string() && (name.empty() || name.size() > kLongestBlockName))
    add_problem(place, ErrorCode::OutOfRange,
                "must have 1 to " + std::to_string(kLongestBlockName) + " bytes");
  return name;
}

std::string read_instruction(const JsonPlace& place) {
  std::string instruction = read_string(place);
  if (place.value.is_string() && instruction.empty())
    add_problem(place, ErrorCode::OutOfRange, "is empty, must say what is done");
  return instruction;
}

bool read_exam_letter(const JsonPlace& place) {
  return read_choice(place, {"A", "B"}).value_or(0) == 1;
}

ScheduleBlock read_block(const JsonPlace& place) {
  ScheduleBlock block;
  if (place.value.is_object() && place.value.contains("instruction")) {
    read_fields(place, {{"name", into(block.name, read_block_name)},
                        {"instruction", into(block.instruction, read_instruction)},
                        {"swap", into(block.swap, read_string), false}});
    return block;
  }
  const auto read_cases = [](const JsonPlace& at) { return read_integer_in(at, 1, kMostCases); };
  const auto read_repeats = [&](const JsonPlace& at) {  // "cases" are read before
    return read_integer_in(at, 0, block.cases > 0 ? block.cases : kMostCases);
  };
  const auto read_seconds = [](const JsonPlace& at) {
    return read_integer_in(at, 0, kMostSeconds);
  };
  read_fields(place, {{"name", into(block.name, read_block_name)},
                      {"exam", into(block.segments, read_exam_letter)},
                      {"cases", into(block.cases, read_cases)},
                      {"repeats", into(block.repeats, read_repeats), false},
                      {"seconds", into(block.seconds, read_seconds), false}});
  return block;
}

}  // namespace

Expected<Schedule> schedule_from_json(const Json& json) {
  ProblemList problems;
  const JsonPlace top{json, problems};
  Schedule schedule;
  read_fields(
      top,
      {{"schema", [](const JsonPlace& place) { read_schema(place, "coapt.training_schedule/1"); }},
       {"name", into(schedule.name, read_block_name)},
       {"title", into(schedule.title, read_string)},
       {"notes", [&](const JsonPlace& place) { schedule.notes = read_list(place, read_string); },
        false},
       {"blocks", [&](const JsonPlace& place) {
          schedule.blocks = read_list(place, read_block);
          if (place.value.is_array() &&
              (schedule.blocks.empty() || schedule.blocks.size() > kMostBlocks))
            add_problem(place, ErrorCode::OutOfRange,
                        "must have 1 to " + std::to_string(kMostBlocks) + " blocks");
        }}});
  if (!problems.empty()) return std::move(problems).take();
  return schedule;
}

Expected<Schedule> read_schedule(std::string_view text) {
  const Expected<Json> json = parse_json(text);
  if (!json) return json.errors();
  return schedule_from_json(*json);
}

Json exam_to_json(const Schedule& schedule, std::uint64_t learner_seed, std::uint64_t first_seed) {
  Json blocks = Json::array();
  for (const ScheduledBlock& laid : lay_out(schedule, learner_seed, first_seed)) {
    Json block = {{"name", laid.block.name}};
    if (!laid.block.instruction.empty()) {
      block["instruction"] = laid.block.instruction;
    } else {
      block["exam"] = laid.block.segments ? "B" : "A";
      block["seconds"] = laid.block.seconds;
      Json& trials = block["trials"] = Json::array();
      for (const ScheduledTrial& trial : laid.trials)
        trials.push_back({{"seed", trial.seed}, {"repeated", trial.repeated}});
    }
    blocks.push_back(std::move(block));
  }
  return result_document("coapt.training_exam/1", {{"name", schedule.name},
                                                   {"title", schedule.title},
                                                   {"notes", schedule.notes},
                                                   {"seed", learner_seed},
                                                   {"first_case", first_seed},
                                                   {"blocks", std::move(blocks)}});
}

}  // namespace coapt
