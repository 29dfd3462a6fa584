#include "search/plans/objective.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "core/repair/apply_plan.h"
#include "tests/scenes/small_valve.h"

namespace coapt {
namespace {

constexpr double kTolerance = 1e-12;

PlanClosure competent() {
  PlanClosure closure;
  closure.coaptation_mm = 8.0;
  closure.distance_max_mm = 1.0;
  closure.tension_max_n = 1.0;
  return closure;
}

PlanClosure leaking(double leak_mm2) {
  PlanClosure closure = competent();
  closure.leak_mm2 = leak_mm2;
  return closure;
}

PlanClosure crossed() {
  PlanClosure closure = competent();
  closure.crossing = true;
  return closure;
}

double cost_of(const std::vector<ScoredClosure>& closures, const Effort& effort = {}) {
  return plan_cost(closures, effort, {1.0, 1.0, {}});
}

double cost_of(const PlanClosure& closure, const Effort& effort = {}) {
  return cost_of(std::vector<ScoredClosure>{{closure, 0.0}}, effort);
}

TEST(PlanCost, IsZeroForAPerfectValveLeftAlone) { EXPECT_EQ(cost_of(competent()), 0.0); }

TEST(PlanCost, PricesAddUp) {
  PlanClosure closure = leaking(7.0);  // 7 + 5 x 6, and 1 because it leaks at once
  closure.coaptation_mm = 6.0;         // 2 x 0.5
  closure.distance_max_mm = 1.5;       // 0.5 x 2
  closure.tension_max_n = 1.25;        // 0.25
  EXPECT_NEAR(cost_of(closure), 37.0 + 1.0 + 1.0 + 1.0 + 0.25, kTolerance);
  // 5 and 12 mm of movement: 3.4 + 2; 5 sizes: 2.5 + 2; 3 steps.
  const Effort asked = {5.0, 12.0, 5.0, 3};
  EXPECT_NEAR(effort_price(asked), 5.4 + 4.5 + 3.0, kTolerance);
  EXPECT_NEAR(cost_of(closure, asked), cost_of(closure) + effort_price(asked), kTolerance);
  EXPECT_NEAR(movement_price(12.0), 2.4 + 2.0, kTolerance);
}

TEST(PlanCost, CountsMeanAndSdOfTheLeakAndHowFarItIs) {
  // Mean 1, sd 1; 5 for the 1 mm2 above 1; half of the margin is left.
  EXPECT_NEAR(cost_of({{leaking(0.0), 0.0}, {leaking(2.0), 0.5}}), 2.0 + 5.0 + 0.5, kTolerance);
  // The nearest leak counts, and 1 mm2 is none.
  EXPECT_NEAR(cost_of({{leaking(1.0), 0.0}, {leaking(1.0), 0.4}}), 1.0, kTolerance);
  EXPECT_NEAR(cost_of({{leaking(2.0), 0.2}, {leaking(2.0), 0.6}}), 2.0 + 5.0 + 0.8, kTolerance);
}

TEST(PlanCost, StillSlopesWhereNothingLeaks) {
  PlanClosure less = competent();
  less.coaptation_mm = 7.0;
  EXPECT_NEAR(cost_of(less), 0.5, kTolerance);
  PlanClosure hidden = competent();
  hidden.distance_max_mm = 2.0;
  EXPECT_NEAR(cost_of(hidden), 2.0, kTolerance);
  PlanClosure taut = competent();
  taut.tension_max_n = 1.5;
  EXPECT_NEAR(cost_of(taut), 0.5, kTolerance);
  EXPECT_NEAR(cost_of({{less, 0.0}, {competent(), 0.5}}), 0.25, kTolerance) << "mean of closures";
  EXPECT_GT(cost_of(competent(), {1.0, 0.0, 0.0, 1}), cost_of(competent(), {0.5, 0.0, 0.0, 1}));
  PlanClosure better = competent();  // than is aimed at, or than before: no reward
  better.coaptation_mm = 12.0;
  better.distance_max_mm = 0.5;
  better.tension_max_n = 0.1;
  EXPECT_EQ(cost_of(better), 0.0);
}

TEST(PlanCost, CompetenceOutbidsComfort) {
  // 1 mm2 less for a step more that moves both muscles by 5 mm, or takes two sizes.
  EXPECT_LT(cost_of(leaking(2.0), {5.0, 5.0, 0.0, 1}), cost_of(leaking(3.0)));
  EXPECT_LT(cost_of(leaking(2.0), {0.0, 0.0, 2.0, 1}), cost_of(leaking(3.0)));
  // Between competent plans the lesser operation wins.
  EXPECT_GT(cost_of(leaking(0.0), {0.0, 0.0, 0.0, 1}), cost_of(leaking(0.5)));
}

TEST(PlanCost, FailedClosuresArePaidForByTheirShare) {
  EXPECT_NEAR(
      cost_of({{competent(), 0.0}, {crossed(), 0.2}, {competent(), 0.4}, {competent(), 1.0}}),
      2500.0, 1e-9);
  EXPECT_NEAR(cost_of(crossed()), 20000.0, 1e-9);
  EXPECT_GT(cost_of({{leaking(0.0), 0.0}, {crossed(), 1.0}}), cost_of(leaking(200.0)));
  PlanClosure limited = competent(), lost = competent(), open = competent(), blind = competent();
  limited.status = ClosureStatus::StepLimit;
  lost.status = ClosureStatus::Diverged;
  lost.leak_mm2 = std::numeric_limits<double>::quiet_NaN();
  open.distance_max_mm = std::numeric_limits<double>::infinity();
  blind.coaptation_mm = std::numeric_limits<double>::quiet_NaN();
  for (const PlanClosure& failed : {limited, lost, open, blind})
    EXPECT_NEAR(cost_of(failed), 20000.0, 1e-9);
}

TEST(PlanCost, KnowsNoTensionWhereThatOfTheValveBeforeIsUnknown) {
  PlanClosure taut = competent();
  taut.tension_max_n = 50.0;
  const std::vector<ScoredClosure> closures = {{taut, 0.0}};
  EXPECT_EQ(plan_cost(closures, {}, {1.0, std::numeric_limits<double>::infinity(), {}}), 0.0);
}

TEST(Effort, CountsMovementSizesAndSteps) {
  const Valve valve = small_valve();
  const double distance = (valve.heads[0].tip_mm - Vec3(0.0, 14.0, 0.0)).norm();
  const RepairPlan plan{{PapillaryApproximation{.side = Side::Anterolateral,
                                                .anchor = Anchor::SaddlePeak,
                                                .suture_length_mm = distance - 4.0},
                         ChordalExcision{"PM1-A2-strut-1"}}};
  const Effort asked = effort(valve, *apply_plan(valve, plan), plan);
  EXPECT_NEAR(asked.anterolateral_movement_mm, 4.0, 1e-12);
  EXPECT_EQ(asked.posteromedial_movement_mm, 0.0);
  EXPECT_EQ(asked.sizes_below, 0.0);
  EXPECT_EQ(asked.steps, 2);
}

TEST(Effort, IsABoundFromBelow) {
  const Effort asked = {3.0, 11.0, 2.0, 2};
  EXPECT_EQ(cost_of(competent(), asked), effort_price(asked));
  for (const PlanClosure& closure : {leaking(1.0), leaking(9.0), crossed()})
    EXPECT_GE(cost_of(closure, asked), effort_price(asked));
}

TEST(Effort, SizesCountTheAreaThatIsLostToTheTrueSize) {
  // 36 x 28 mm; the true size is 36 x 27. Three sizes below in proportion: 30 x 23.33.
  const Valve valve = fitting_valve();
  const RepairPlan plan{{Annuloplasty{OwnRing{3}}}};
  const double share = 30.0 * (28.0 * 30.0 / 36.0) / (36.0 * 27.0);
  EXPECT_NEAR(effort(valve, *apply_plan(valve, plan), plan).sizes_below,
              18.0 * (1.0 - std::sqrt(share)), 1e-9);
  // A ring of the same width and depth takes nothing away, whatever the vertices make
  // of it.
  const RepairPlan same{{Annuloplasty{OwnRing{0}}}};
  EXPECT_EQ(ring_sizes_below(valve, *apply_plan(valve, same)), 0.0);
}

}  // namespace
}  // namespace coapt
