// Own plans: scored and ranked as those of a search.
#include <cmath>

#include "search/plans/plan_search.h"
#include "tests/search/plans/search_scene.h"

namespace coapt::scene {
namespace {

// 9 mm nearer: no disturbance of the region takes back half of it.
const RepairPlan kAnterolateral = suture(Side::Anterolateral, kTipToTrigone_mm - 9.0);
const RepairPlan kPosteromedial = suture(Side::Posteromedial, kTipToTrigone_mm - 9.0);
bool is_sutured(const Valve& valve, Side side) { return moved_mm(valve, side) > 4.5; }

Expected<SearchResult> evaluated(const std::vector<NamedPlan>& plans, const Evaluator& evaluate,
                                 int region_points = 17) {
  SearchOptions options = small_search();
  options.region_points = region_points;
  return evaluate_plans(fitting_valve(), plans, options, context_of(evaluate));
}

/// Both muscles tied: 1 mm2. The posteromedial one: 3. The anterolateral one: 4. Else 9.
double leak_by_sutures(const Valve& valve) {
  const bool al = is_sutured(valve, Side::Anterolateral);
  const bool pm = is_sutured(valve, Side::Posteromedial);
  return al && pm ? 1.0 : pm ? 3.0 : al ? 4.0 : 9.0;
}

TEST(EvaluatePlans, RanksOwnPlansUnderTheirNames) {
  const auto result = evaluated({{"al", kAnterolateral},
                                 {"pm", kPosteromedial},
                                 {"nothing", {}},
                                 {"both", both(kAnterolateral, kPosteromedial)}},
                                leak_of(leak_by_sutures));
  ASSERT_TRUE(result);
  std::vector<std::string> names;
  for (const RankedPlan& plan : result->plans) names.push_back(plan.name);
  EXPECT_EQ(names, (std::vector<std::string>{"both", "pm", "al", "nothing"}));
  for (const RankedPlan& plan : result->plans) EXPECT_EQ(plan.region.closures, 17);
  EXPECT_EQ(result->plans_tried, 4);
  EXPECT_EQ(result->closures, 1 + 4 * 17);
  EXPECT_EQ(result->before.measure.leak.area_mm2, 9.0);
  EXPECT_FALSE(result->any_acceptable) << "32 triangles do not tell 1 from 5 mm2";
}

TEST(EvaluatePlans, CostsAreThoseWorkedOutByHand) {
  const auto result = evaluated({{"pm", kPosteromedial}}, leak_of(leak_by_sutures));
  ASSERT_TRUE(result);
  // A step, 9 mm at 0.2, 3 mm2 of which 2 count five times more; as planned it leaks: the whole margin.
  EXPECT_NEAR(result->plans.at(0).cost, 1.0 + 1.8 + 3.0 + 10.0 + 1.0, 1e-9);
  EXPECT_EQ(result->plans[0].subset_nodes, 17);
  EXPECT_EQ(result->plans[0].subset_cost, result->plans[0].cost);
}

TEST(EvaluatePlans, PlansThatNoneBeatsAreMarked) {
  const auto result = evaluated({{"al", kAnterolateral},
                                 {"pm", kPosteromedial},
                                 {"both", both(kAnterolateral, kPosteromedial)}},
                                leak_of(leak_by_sutures));
  ASSERT_TRUE(result);
  for (const RankedPlan& plan : result->plans) EXPECT_EQ(plan.pareto, plan.name != "al");
}

TEST(EvaluatePlans, ChancesAreHighForTheClearlyBetter) {
  const auto leak = [](const Valve& valve) { return has_ring(valve) ? 12.0 : 2.0; };
  const auto result = evaluated(
      {{"worse", own_ring(1)}, {"al", kAnterolateral}, {"pm", kPosteromedial}}, leak_of(leak));
  ASSERT_TRUE(result);
  ASSERT_EQ(result->plans.size(), 3u);
  EXPECT_EQ(result->plans[2].name, "worse");
  EXPECT_NEAR(result->plans[1].probability_outranks_next, 0.99, 0.01);
  EXPECT_TRUE(std::isnan(result->plans[2].probability_outranks_next));
}

TEST(EvaluatePlans, ChancesLieBetweenNoneAndOne) {
  std::vector<NamedPlan> plans;
  for (int k = 0; k < 8; ++k)
    plans.push_back({std::to_string(k), suture(Side::Posteromedial, 20.0 + k)});
  const auto result = evaluated(plans, needs_suture);
  ASSERT_TRUE(result);
  for (std::size_t i = 0; i + 1 < result->plans.size(); ++i) {
    EXPECT_GE(result->plans[i].probability_outranks_next, 0.0);
    EXPECT_LE(result->plans[i].probability_outranks_next, 1.0);
  }
}

TEST(EvaluatePlans, APlanGivenTwiceIsRankedOnce) {
  const RepairPlan forwards = both(own_ring(2), kPosteromedial);
  const RepairPlan backwards = both(kPosteromedial, own_ring(2));
  std::atomic<int> calls = 0;
  const auto result =
      evaluated({{"first", forwards}, {"second", backwards}}, counted(needs_suture, calls));
  ASSERT_TRUE(result);
  ASSERT_EQ(result->plans.size(), 1u);
  EXPECT_EQ(result->plans[0].name, "first, second");
  EXPECT_EQ(result->plans_tried, 1);
  EXPECT_EQ(calls, 1 + 17);
}

TEST(EvaluatePlans, WithoutARegionPlansAreClosedAsPlanned) {
  const auto result =
      evaluated({{"al", kAnterolateral}, {"pm", kPosteromedial}}, leak_of(leak_by_sutures), 1);
  ASSERT_TRUE(result);
  ASSERT_EQ(result->plans.size(), 2u);
  EXPECT_EQ(result->plans[0].name, "pm");
  EXPECT_EQ(result->plans[0].region.leak_mm2.nominal, 3.0);
  EXPECT_EQ(result->closures, 1 + 2);
}

TEST(EvaluatePlans, APlanThatFailsInItsRegionIsRankedBehindOneThatDoesNot) {
  // The ring closes the valve as long as the tips are just so; the suture leaves a leak everywhere.
  const Evaluator evaluate = [](const Valve& valve, const ClosureResult*) {
    Evaluation evaluation = leaking(has_ring(valve) ? 0.0 : 9.0);
    evaluation.crossing = has_ring(valve) && moved_mm(valve, Side::Posteromedial) > 1e-9;
    return ClosedPlan{evaluation, nullptr};
  };
  const auto result = evaluated({{"ring", own_ring(1)}, {"suture", kPosteromedial}}, evaluate);
  ASSERT_TRUE(result);
  ASSERT_EQ(result->plans.size(), 2u);
  EXPECT_EQ(result->plans[0].name, "suture");
  EXPECT_EQ(result->plans[1].region.failures, 16);
  EXPECT_EQ(result->plans[1].region.leak_mm2.nominal, 0.0);
  EXPECT_EQ(result->closures_crossed, 16);
}

TEST(EvaluatePlans, APlanThatPracticeRejectsIsScoredAllTheSame) {
  const auto result = evaluated({{"tiny", own_ring(6)}}, needs_suture);
  ASSERT_TRUE(result);
  ASSERT_EQ(result->plans.size(), 1u);
  EXPECT_TRUE(is_rejected(result->plans[0].gates));
  EXPECT_FALSE(result->plans[0].warnings.empty());
}

TEST(EvaluatePlans, AnImpossiblePlanIsAnErrorAtItsStep) {
  const RepairPlan slack = suture(Side::Posteromedial, 99.0);
  const auto refused = evaluated(
      {{"a", own_ring(1)}, {"b", slack}, {"c", both(own_ring(1), own_ring(2))}}, needs_suture);
  EXPECT_EQ(paths_of(refused),
            (std::vector<std::string>{"/plans/1/steps/0/suture_length_mm", "/plans/2/steps/1"}));
  EXPECT_EQ(paths_of(evaluated({}, needs_suture)), (std::vector<std::string>{"/plans"}));
  EXPECT_EQ(paths_of(evaluated({}, needs_suture, 0)),
            (std::vector<std::string>{"/region_points", "/plans"}));
}

}  // namespace
}  // namespace coapt::scene
