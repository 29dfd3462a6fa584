// Schedules of studies and courses: coapt.training_schedule/1 (examples/training), and what comes of one for a learner.
#pragma once

#include "io/json/json.h"
#include "search/training/schedule.h"

namespace coapt {

/// {"schema", "name", "title", "notes": [...], "blocks": [{"name", "exam": "A" or "B", "cases", "repeats", "seconds"} or {"name",
/// "instruction", "swap"}]}.
Expected<Schedule> read_schedule(std::string_view text);
Expected<Schedule> schedule_from_json(const Json& json);

/// coapt.training_exam/1: the blocks, of those with trials a list {"seed", "repeated"}.
Json exam_to_json(const Schedule& schedule, std::uint64_t learner_seed, std::uint64_t first_seed);

}  // namespace coapt
