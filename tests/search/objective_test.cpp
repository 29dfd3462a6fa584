#include "search/objective.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/repair/apply_plan.h"
#include "tests/scenes/small_valve.h"

namespace coapt {
namespace {

Evaluation competent() {
  Evaluation evaluation;
  for (CoaptationSection& section : evaluation.measure.coaptation.sections) section.height_mm = 8.0;
  evaluation.measure.coaptation.distance_max_mm = 1.0;
  evaluation.measure.tension_max_n = 1.0;
  return evaluation;
}

double cost_of(const Evaluation& evaluation, const Effort& effort = {}) {
  return cost(evaluation, effort, 1.0, 1.0);
}

TEST(Cost, IsZeroForAPerfectValveLeftAlone) { EXPECT_EQ(cost_of(competent()), 0.0); }

TEST(Cost, PricesAddUp) {
  Evaluation evaluation = competent();
  evaluation.measure.orifice.area_mm2 = 7.0;  // 7 + 2 x 2
  for (const std::size_t i : {3u, 4u, 5u})
    evaluation.measure.coaptation.sections[i].height_mm = 6.0;  // 2 x 0.5
  evaluation.measure.coaptation.distance_max_mm = 1.5;          // 0.5 x 2
  evaluation.measure.tension_max_n = 1.25;                      // 0.25
  EXPECT_DOUBLE_EQ(cost_of(evaluation), 11.0 + 1.0 + 1.0 + 0.25);
  // 5 and 12 mm of movement: 3.4 + 2; 5 sizes: 2.5 + 2; 3 steps.
  EXPECT_NEAR(cost_of(evaluation, {5.0, 12.0, 5.0, 3}), 13.25 + 5.4 + 4.5 + 3.0, 1e-12);
}

TEST(Cost, StillSlopesWhereTheOrificeIsZero) {
  Evaluation less = competent();
  less.measure.coaptation.sections[4].height_mm = 7.0;
  EXPECT_GT(cost_of(less), cost_of(competent()));
  Evaluation hidden = competent();
  hidden.measure.coaptation.distance_max_mm = 2.0;
  EXPECT_GT(cost_of(hidden), cost_of(competent()));
  EXPECT_GT(cost_of(competent(), {1.0, 0.0, 0.0, 1}), cost_of(competent(), {0.5, 0.0, 0.0, 1}));
}

TEST(Cost, AClosureThatFailedIsWorseThanAnyThatDidNot) {
  Evaluation leaking = competent();
  leaking.measure.orifice.area_mm2 = 200.0;
  Evaluation crossed = competent(), limited = competent(), lost = competent();
  crossed.crossing = true;
  limited.status = ClosureStatus::StepLimit;
  lost.status = ClosureStatus::Diverged;
  lost.measure.orifice.area_mm2 = std::numeric_limits<double>::quiet_NaN();
  EXPECT_GT(cost_of(crossed), cost_of(leaking));
  EXPECT_GT(cost_of(limited), cost_of(leaking));
  EXPECT_GT(cost_of(lost), cost_of(crossed));
  EXPECT_TRUE(std::isfinite(cost_of(lost)));
}

TEST(Effort, CountsMovementSizesAndSteps) {
  const Valve valve = small_valve();
  const double distance = (valve.heads[0].tip_mm - Vec3(0.0, 14.0, 0.0)).norm();
  const RepairPlan plan{{PapillaryApproximation{.side = Side::Anterolateral,
                                                .anchor = Anchor::SaddlePeak,
                                                .suture_length_mm = distance - 4.0},
                         ChordalExcision{"PM1-A2-strut-1"}}};
  const Effort asked = effort(valve, *apply_plan(valve, plan, {}), plan);
  EXPECT_NEAR(asked.anterolateral_movement_mm, 4.0, 1e-12);
  EXPECT_EQ(asked.posteromedial_movement_mm, 0.0);
  EXPECT_EQ(asked.sizes_below, 0.0);
  EXPECT_EQ(asked.steps, 2);
}

TEST(Effort, SizesCountTheAreaThatIsLostToAHealthyAnnulus) {
  // 36 x 28 mm; healthy would be 36 x 27. Three sizes below in proportion: 30 x 23.33.
  const Valve valve = small_valve();
  const RepairPlan plan{{Annuloplasty{.shape = "own", .sizes_below = 3}}};
  const double share = 30.0 * (28.0 * 30.0 / 36.0) / (36.0 * 27.0);
  EXPECT_NEAR(effort(valve, *apply_plan(valve, plan, {}), plan).sizes_below,
              18.0 * (1.0 - std::sqrt(share)), 1e-9);
  // A ring of healthy proportion and the same width takes nothing away, whatever the vertices make
  // of it.
  const RepairPlan same{{Annuloplasty{.shape = "own", .sizes_below = 0}}};
  EXPECT_EQ(ring_sizes_below(valve, *apply_plan(valve, same, {})), 0.0);
}

}  // namespace
}  // namespace coapt
