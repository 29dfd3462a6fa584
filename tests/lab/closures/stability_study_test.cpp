#include "lab/closures/stability_study.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace coapt {
namespace {

/// Says that it is at rest where it began.
ClosureRun lie(const ClosureModel& model, const AttemptSettings&) {
  ClosureRun run;
  run.status = ClosureStatus::Converged;
  run.x_mm = model.rest_mm;
  run.steps = 1;
  return run;
}

ClosureRun explode(const ClosureModel& model, const AttemptSettings&) {
  ClosureRun run = lie(model, {});
  run.x_mm(0, 0) = std::numeric_limits<double>::quiet_NaN();
  return run;
}

StabilityStudyOptions reduced(const std::vector<DifficultyAxis>& axes) {
  StabilityStudyOptions options;
  options.scenes = {"human-normal"};
  options.axes = axes;
  return options;
}

const StabilityCell& find(const std::vector<StabilityCell>& cells, const std::string& method,
                          double level) {
  for (const StabilityCell& cell : cells)
    if (cell.method == method && cell.level == level) return cell;
  throw std::out_of_range(method);
}

TEST(StabilityStudy, JudgesEachMethodItselfAndBelievesNone) {
  int calls = 0;
  const std::vector<StabilityCell> cells =
      study_stability(reduced({{Difficulty::ContactStiffness, {0.3, 1.0}, 1.0}}),
                      {{"liar", lie}, {"bomb", explode}}, [&](int done, int planned) {
                        EXPECT_EQ(done, ++calls);
                        EXPECT_EQ(planned, 2);
                      });
  ASSERT_EQ(cells.size(), 16u);
  EXPECT_EQ(calls, 2);
  EXPECT_EQ(find(cells, "liar", 1.0).outcome, StabilityOutcome::Stalls);
  EXPECT_GT(find(cells, "liar", 1.0).residual, 0.5);
  EXPECT_EQ(find(cells, "bomb", 1.0).outcome, StabilityOutcome::BlowsUp);
  EXPECT_TRUE(std::isnan(find(cells, "bomb", 1.0).from_reference_mm));
  EXPECT_TRUE(find(cells, "fast", 1.0).nominal);
  // Contact a third as stiff as nominal: leaflets pass, but not where guards or the ladder see to it.
  EXPECT_EQ(find(cells, "unguarded", 0.3).outcome, StabilityOutcome::Crosses);
  EXPECT_GT(find(cells, "unguarded", 0.3).crossing_pairs, 0);
  EXPECT_EQ(find(cells, "fast", 0.3).crossing_pairs, 0);
  const StabilityCell& ladder = find(cells, "coapt", 0.3);
  EXPECT_EQ(ladder.outcome, StabilityOutcome::Settles);
  EXPECT_EQ(ladder.crossing_pairs, 0);
  EXPECT_LT(ladder.end_from_reference_mm, 0.05);
}

TEST(StabilityStudy, IsTheSameForAnyNumberOfThreadsButForTheTimes) {
  StabilityStudyOptions options = reduced(
      {{Difficulty::Step, {1.0, 3.0}, 1.0}, {Difficulty::Resolution, {300.0, 650.0}, 650.0}});
  options.threads = 1;
  const std::vector<StabilityCell> one = study_stability(options, {{"liar", lie, 400}});
  options.threads = 2;
  const std::vector<StabilityCell> two = study_stability(options, {{"liar", lie, 400}});
  ASSERT_EQ(one.size(), two.size());
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_EQ(one[i].method, two[i].method);
    EXPECT_EQ(one[i].outcome, two[i].outcome);
    EXPECT_EQ(one[i].steps, two[i].steps);
    EXPECT_EQ(one[i].residual, two[i].residual);
  }
  // A step three times as long is beyond the bound; the ladder has none to vary, a method is left out where
  // meshes are too fine for it, and the nominal level is closed once.
  EXPECT_EQ(find(one, "thesis", 3.0).outcome, StabilityOutcome::Stalls);
  EXPECT_EQ(find(one, "fast", 3.0).outcome, StabilityOutcome::Stalls);
  EXPECT_THROW(find(one, "coapt", 3.0), std::out_of_range);
  EXPECT_EQ(find(one, "liar", 300.0).axis, Difficulty::Resolution);
  EXPECT_THROW(find(one, "liar", 1.0), std::out_of_range);
  EXPECT_THROW(find(one, "liar", 650.0), std::out_of_range);
  EXPECT_EQ(find(one, "fast", 650.0).seconds, find(one, "fast", 1.0).seconds);
}

}  // namespace
}  // namespace coapt
