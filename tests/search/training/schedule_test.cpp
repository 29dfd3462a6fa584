#include "search/training/schedule.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

namespace coapt {
namespace {

ScheduleBlock exam(const char* name, int cases, int repeats = 0) {
  return {.name = name, .cases = cases, .repeats = repeats};
}
ScheduleBlock lesson(const char* name) {
  return {.name = name, .instruction = "read", .swap = "instruction"};
}

TEST(Schedule, SixCasesAndFourRepeatsAreTenTrialsOfSixCases) {
  const auto laid = lay_out({"s", "", {}, {exam("exam", 6, 4)}}, 11);
  ASSERT_EQ(laid.size(), 1u);
  std::map<std::uint64_t, int> times;
  int repeated = 0;
  for (const ScheduledTrial& trial : laid[0].trials) {
    EXPECT_EQ(trial.repeated, times[trial.seed]++ > 0);
    repeated += trial.repeated ? 1 : 0;
  }
  EXPECT_EQ(laid[0].trials.size(), 10u);
  EXPECT_EQ(times.size(), 6u);
  EXPECT_EQ(repeated, 4);
  for (std::size_t i = 1; i < 10; ++i)
    EXPECT_NE(laid[0].trials[i].seed, laid[0].trials[i - 1].seed);
}

TEST(Schedule, InstructionChangesPlacesAndCasesChangeBlocks) {
  const Schedule study{
      "s", "", {}, {exam("1", 5), lesson("book"), exam("2", 5), lesson("virtual"), exam("3", 5)}};
  std::set<std::string> first_lessons;
  std::set<std::uint64_t> first_cases;
  for (std::uint64_t learner = 1; learner <= 20; ++learner) {
    const auto laid = lay_out(study, learner, 100);
    first_lessons.insert(laid[1].block.name);
    first_cases.insert(laid[0].trials[0].seed);
    std::set<std::uint64_t> all;
    for (const ScheduledBlock& block : laid)
      for (const ScheduledTrial& trial : block.trials) all.insert(trial.seed);
    EXPECT_EQ(all.size(), 15u);
    EXPECT_EQ(*all.begin(), 100u);
    EXPECT_EQ(*all.rbegin(), 114u);
    EXPECT_EQ(laid[2].block.name, "2");
  }
  EXPECT_EQ(first_lessons.size(), 2u);
  EXPECT_GT(first_cases.size(), 5u);
}

}  // namespace
}  // namespace coapt
