// Schedules of studies and courses: blocks of trials and of instruction, in an order that a learner's seed draws (the thesis's three
// are in examples/training).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/valve/types.h"

namespace coapt {

/// Instruction: no trials, a text says what is done. Trials: `cases` different cases, `repeats` of which come twice.
struct ScheduleBlock {
  std::string name{};
  std::string instruction{};  ///< empty: a block of trials
  bool segments = false;      ///< exam B
  int cases = 0, repeats = 0;
  int seconds = 180;  ///< of analysis of a trial, at most; 0: no limit
  /// Blocks of instruction with the same one, not empty, change places at random.
  std::string swap{};
};

struct Schedule {
  std::string name, title;
  std::vector<std::string> notes;
  std::vector<ScheduleBlock> blocks;
};

struct ScheduledTrial {
  std::uint64_t seed = 1;  ///< of its case
  bool repeated = false;   ///< the same case was in this block before
};
struct ScheduledBlock {
  ScheduleBlock block;
  std::vector<ScheduledTrial> trials;
};

/// The cases of a schedule are the same for all learners: seeds from `first_seed` on. The learner's seed draws which block they come in (of the
/// same exam), their order, which of them are repeated, and the order of instruction. No case is made: some seeds make none.
std::vector<ScheduledBlock> lay_out(const Schedule& schedule, std::uint64_t learner_seed,
                                    std::uint64_t first_seed = 1);

}  // namespace coapt
