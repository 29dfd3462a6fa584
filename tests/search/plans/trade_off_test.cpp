#include "search/plans/trade_off.h"

#include <array>
#include <random>

#include "search/plans/durability.h"
#include "tests/search/plans/search_scene.h"

namespace coapt::scene {
namespace {

TEST(DominatedVolume, OfOnePlanIsItsBoxAndOfTwoTheUnion) {
  const TradeOff tight{1.0, 250.0, 6.0}, wide{3.0, 350.0, 3.0};
  EXPECT_EQ(dominated_volume({}), 0.0);
  EXPECT_DOUBLE_EQ(dominated_volume(std::array{tight}), 4.0 * 100.0 * 6.0);
  EXPECT_DOUBLE_EQ(dominated_volume(std::array{tight, wide}), 2400.0 + 1200.0 - 2.0 * 100.0 * 3.0);
  EXPECT_DOUBLE_EQ(dominated_volume(std::array{tight, tight}), 2400.0);
  EXPECT_EQ(dominated_volume(std::array{TradeOff{1.0, 250.0, 0.0}}), 0.0);
}

TEST(DominatedVolume, IsTheCellsThatAPlanIsAsGoodAs) {
  std::mt19937_64 engine(7);
  const auto whole = [&engine](int most) { return static_cast<double>(1 + engine() % most); };
  for (int round = 0; round < 50; ++round) {
    std::vector<TradeOff> plans;
    for (int i = 0; i < 1 + round % 9; ++i)
      plans.push_back(
          {kWorstAccepted.leak_mm2 - whole(5), kWorstAccepted.opening_mm2 + whole(6), whole(7)});
    int cells = 0;
    for (int leak = 1; leak <= 5; ++leak)
      for (int opening = 1; opening <= 6; ++opening)
        for (int lasts = 1; lasts <= 7; ++lasts)
          cells += std::any_of(plans.begin(), plans.end(), [&](const TradeOff& plan) {
            return kWorstAccepted.leak_mm2 - plan.leak_mm2 >= leak &&
                   plan.opening_mm2 - kWorstAccepted.opening_mm2 >= opening &&
                   plan.durability_mm >= lasts;
          });
    EXPECT_DOUBLE_EQ(dominated_volume(plans), cells);
  }
}

PlanEvaluationOptions opening_by(double mm2) {
  PlanEvaluationOptions options = on_threads(1);
  options.open = [mm2](const Valve&) {
    PlanOpening opening;
    opening.measure.opening_area_mm2 = opening.measure.projected_area_mm2 = mm2;
    return opening;
  };
  return options;
}

/// Closures of a suture to 20 mm, measured.
int closures_of(double leak_mm2, double opens_mm2, std::optional<TradeOff>* found = nullptr) {
  EvaluationScene scene(leak_of([leak_mm2](const Valve&) { return leak_mm2; }),
                        opening_by(opens_mm2));
  PlanRecord* plan = &scene.evaluations.record(suture(Side::Posteromedial, 20.0));
  EXPECT_TRUE(
      measure_trade_offs(scene.evaluations, {&plan, 1}, 5, PlanEvaluations::Phase::Searching));
  if (found != nullptr) *found = trade_off(*plan, 5);
  return scene.evaluations.closures() - 1;
}

TEST(MeasureTradeOffs, GoesNoFurtherThanPracticeWouldAccept) {
  EXPECT_EQ(closures_of(6.0, 300.0), 1) << "it leaks as planned";
  EXPECT_EQ(closures_of(1.0, 140.0), 5) << "it opens too little";
  std::optional<TradeOff> found;
  EXPECT_EQ(closures_of(1.0, 300.0, &found), 5 + kDisease.count);
  EXPECT_EQ(found, (TradeOff{1.0, 300.0, kFurthestCourse_mm}));
  closures_of(6.0, 300.0, &found);
  EXPECT_FALSE(found);
}

TEST(MeasureTradeOffs, ACourseEndsAtItsLeak) {
  const Evaluator evaluate = leak_of(
      [](const Valve& valve) { return moved_mm(valve, Side::Posteromedial) > 5.0 ? 20.0 : 0.0; });
  EvaluationScene scene(evaluate, opening_by(300.0));
  PlanRecord* plan = &scene.evaluations.record(own_ring(2));
  EXPECT_TRUE(
      measure_trade_offs(scene.evaluations, {&plan, 1}, 5, PlanEvaluations::Phase::Searching));
  EXPECT_LT(scene.evaluations.closures() - 1, 5 + kDisease.count);
  ASSERT_TRUE(trade_off(*plan, 5));
  EXPECT_LT(trade_off(*plan, 5)->durability_mm, kFurthestCourse_mm);
  EXPECT_EQ(trade_off(*plan, 5)->durability_mm, durability(*plan)->expected_mm);
}

}  // namespace
}  // namespace coapt::scene
