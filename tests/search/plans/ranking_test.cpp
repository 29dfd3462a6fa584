#include "search/plans/ranking.h"

#include <cmath>

#include "search/plans/disturbance.h"
#include "search/plans/pareto.h"
#include "search/plans/trade_off.h"
#include "tests/search/plans/search_scene.h"

namespace coapt::scene {
namespace {

/// Sutures of the posteromedial muscle, the longest first, closed as planned.
std::vector<PlanRecord*> finalists_of(EvaluationScene& scene, int count) {
  std::vector<PlanRecord*> finalists;
  for (int k = 0; k < count; ++k)
    finalists.push_back(&scene.closed(suture(Side::Posteromedial, 27.0 - k), 1));
  return finalists;
}

SearchOptions options_of(int plans, int region_points, bool evidence = false) {
  SearchOptions options = small_search();
  options.plans = plans;
  options.region_points = region_points;
  options.evidence = evidence;
  return options;
}

int region_nodes(const PlanRecord& plan) {
  int nodes = 0;
  for (const auto& [disturbance, closure] : plan.closures) nodes += disturbance < kRegion.count;
  return nodes;
}

TEST(Ranking, FinalistsClimbToTheRegionAndTheDearestAreDropped) {
  for (const int region : {1, 2, 9, 17, 30, 65, 100}) {
    EvaluationScene scene(needs_suture);
    std::vector<LadderStep> ladder;
    const std::vector<PlanRecord*> finalists = finalists_of(scene, 6);
    const int before = scene.evaluations.closures();
    const int taken = ranking_closures(options_of(3, region), finalists);
    const auto stayed =
        close_finalists(scene.evaluations, finalists, options_of(3, region), ladder).kept;
    ASSERT_EQ(stayed.size(), 5u) << region << ": compared, of which 3 are reported";
    for (const PlanRecord* plan : stayed) EXPECT_EQ(region_nodes(*plan), region);
    EXPECT_EQ(scene.evaluations.closures() - before, taken);
    EXPECT_LE(taken, ranking_closures(options_of(3, region)));
    EXPECT_EQ(ladder.size(), region <= 17 ? 0u : region <= 65 ? 1u : 2u);
  }
}

TEST(Ranking, EvidenceIsClosedForAllAndForTheMusclesThatAreSutured) {
  EvaluationScene scene(leak_of([](const Valve&) { return 0.0; }));  // every course to its end
  const RepairPlan al = suture(Side::Anterolateral, 22.0), pm = suture(Side::Posteromedial, 22.0);
  std::vector<LadderStep> ladder;
  const SearchOptions options = options_of(4, 2, true);
  const std::vector<PlanRecord*> finalists = {
      &scene.evaluations.record(own_ring(1)), &scene.evaluations.record(al),
      &scene.evaluations.record(pm), &scene.evaluations.record(both(al, pm))};
  const int taken = ranking_closures(options, finalists);
  close_evidence(scene.evaluations,
                 close_finalists(scene.evaluations, finalists, options, ladder).kept);
  EXPECT_EQ(scene.evaluations.closures() - 1, taken);
  EXPECT_EQ(finalists[0]->closures.size(), 2u + 24u + 24u + 64u);
  EXPECT_EQ(finalists[1]->closures.size(), 2u + 24u + 24u + 64u + 98u);
  EXPECT_EQ(finalists[2]->closures.size(), 2u + 24u + 24u + 64u + 98u);
  EXPECT_EQ(finalists[3]->closures.size(), 2u + 24u + 24u + 64u + 98u + 98u);
  EXPECT_TRUE(finalists[1]->closures.contains(kAnterolateralAlone.first));
  EXPECT_TRUE(finalists[2]->closures.contains(kPosteromedialAlone.first));
  EXPECT_LE(scene.evaluations.closures() - 1, ranking_closures(options));
}

TEST(Ranking, AReserveIsClosedAsFinalistsAre) {
  EvaluationScene scene(leak_of([](const Valve&) { return 0.0; }));  // every course to its end
  const std::vector<PlanRecord*> reserve = finalists_of(scene, 3);
  ASSERT_TRUE(close_reserve(scene.evaluations, reserve, options_of(3, 9, true)));
  for (const PlanRecord* plan : reserve) {
    EXPECT_EQ(region_nodes(*plan), 9);
    EXPECT_EQ(plan->closures.size(), 9u + 24u) << "and under disease";
  }
}

TEST(Ranking, StoppedItComparesOverTheNodesThatAllHave) {
  std::atomic<bool> cancelled = false;
  std::atomic<int> calls = 0;
  // The valve, six plans as planned, nodes 1 and 2 of all six, node 3 of four of them.
  EvaluationScene scene(cancelling(needs_suture, calls, 1 + 6 + 12 + 4, cancelled), on_threads(1),
                        &cancelled);
  std::vector<LadderStep> ladder;
  const auto stayed =
      close_finalists(scene.evaluations, finalists_of(scene, 6), options_of(3, 9), ladder).kept;
  ASSERT_GE(stayed.size(), 4u);
  const std::vector<RankedPlan> plans = rank(scene.evaluations, stayed, over_nodes(17));
  ASSERT_EQ(plans.size(), stayed.size());
  for (const RankedPlan& plan : plans) {
    EXPECT_GE(plan.region.closures, 3);
    EXPECT_EQ(plan.region.closures, plans[0].region.closures);
  }
}

TEST(Ranking, OnRequestPlansComeInTheOrderOfTheirCosts) {
  EvaluationScene scene(leak_of([](const Valve&) { return 0.0; }));
  SearchOptions by_price = over_nodes(8);
  by_price.rank_by_price = true;
  by_price.plans = 6;
  std::vector<PlanRecord*> plans = finalists_of(scene, 6);
  for (PlanRecord* plan : plans) scene.closed(plan->plan, 9);
  const std::vector<RankedPlan> ranked = rank(scene.evaluations, plans, by_price);
  ASSERT_EQ(ranked.size(), 6u);
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_EQ(ranked[i].rank, static_cast<int>(i) + 1);
    const PlanRecord& record = scene.evaluations.record(ranked[i].plan);
    EXPECT_EQ(ranked[i].cost, scene.evaluations.cost(record, 8)) << "of 9 that are closed";
    EXPECT_EQ(ranked[i].subset_nodes, 8);
    EXPECT_EQ(ranked[i].subset_cost, ranked[i].cost);
    if (i == 0) continue;
    EXPECT_LE(ranked[i - 1].cost, ranked[i].cost);
  }
}

TEST(Ranking, AnAcceptablePlanComesBeforeASimplerOneThatIsNot) {
  // The ring leaks at three nodes of nine; two sutures are more work, and tight.
  PlanEvaluationOptions options = on_threads(1);
  const RepairPlan ring = own_ring(1);
  const RepairPlan sutures =
      both(suture(Side::Anterolateral, 19.0), suture(Side::Posteromedial, 19.0));
  for (int d = 0; d < 9; ++d) {
    options.known[plan_key(ring)][d] = closure_leaking(d > 5 ? 30.0 : 0.0);
    options.known[plan_key(sutures)][d] = closure_leaking(0.0);
  }
  EvaluationScene scene(needs_suture, std::move(options));
  const std::vector<RankedPlan> ranked =
      rank(scene.evaluations, {&scene.closed(ring, 9), &scene.closed(sutures, 9)}, over_nodes(9));
  EXPECT_EQ(ranked[0].effort.steps, 2);
  EXPECT_TRUE(ranked[0].is_acceptable);
  EXPECT_GT(ranked[0].acceptable_probability, 0.95);
  EXPECT_FALSE(ranked[1].is_acceptable);
  EXPECT_LT(ranked[1].acceptable_probability, 0.7);
  EXPECT_GT(ranked[1].acceptable_probability, 0.6);
  EXPECT_GT(ranked[0].probability_outranks_next, 0.9);
  EXPECT_FALSE(ranked[0].ties_with_next);
}

TEST(Ranking, OfPlansThatCannotBeToldApartTheSimplestIsFirst) {
  EvaluationScene scene(leak_of([](const Valve&) { return 0.0; }));
  const RepairPlan al = suture(Side::Anterolateral, 19.0), pm = suture(Side::Posteromedial, 19.0);
  const std::vector<RankedPlan> ranked =
      rank(scene.evaluations,
           {&scene.closed(both(al, pm), 9), &scene.closed(own_ring(3), 9),
            &scene.closed(own_ring(1), 9), &scene.closed(pm, 9)},
           over_nodes(9));
  EXPECT_EQ(plan_key(ranked[0].plan), plan_key(own_ring(1)))
      << "a step, no muscle, less undersizing";
  EXPECT_EQ(plan_key(ranked[1].plan), plan_key(own_ring(3)));
  EXPECT_EQ(plan_key(ranked[2].plan), plan_key(pm));
  EXPECT_EQ(ranked[3].effort.steps, 2);
  for (const RankedPlan& plan : ranked) EXPECT_EQ(plan.of_class, 1);
  EXPECT_TRUE(ranked[0].simplest_of_class && ranked[0].ties_with_next);
  EXPECT_FALSE(ranked[1].simplest_of_class);
  EXPECT_FALSE(ranked[3].ties_with_next) << "the last";
  EXPECT_NEAR(ranked[0].probability_outranks_next, 0.5, 0.01);
}

TEST(Ranking, NoPlansAreRankedAsNone) {
  EvaluationScene scene(needs_suture);
  std::vector<LadderStep> ladder;
  EXPECT_TRUE(close_finalists(scene.evaluations, {}, options_of(3, 100), ladder).kept.empty());
  EXPECT_TRUE(rank(scene.evaluations, {}, over_nodes(17)).empty());
}

TEST(ParetoFront, HoldsWhatNothingElseBeatsCheapestFirst) {
  PlanEvaluationOptions options = on_threads(1);
  const auto leaks = [&options](const RepairPlan& plan, double first, double second) {
    options.known[plan_key(plan)] = {{0, closure_leaking(first)}, {1, closure_leaking(second)}};
    return plan;
  };
  const RepairPlan al = suture(Side::Anterolateral, 20.0), pm = suture(Side::Posteromedial, 20.0);
  const RepairPlan beaten = leaks(al, 3.0, 5.0);  // mean 4, sd 1
  const RepairPlan lower = leaks(pm, 1.0, 3.0);   // mean 2, sd 1
  const RepairPlan milder =
      leaks(suture(Side::Posteromedial, 21.0), 6.0, 6.0);  // a millimetre less
  const RepairPlan more = leaks(both(al, pm), 1.0, 1.0);   // two steps
  const RepairPlan failed = leaks(suture(Side::Posteromedial, 22.0), 0.0, std::nan(""));
  EvaluationScene scene(needs_suture, std::move(options));
  std::vector<const PlanRecord*> plans;
  for (const RepairPlan& plan : {milder, beaten, lower, failed, more})
    plans.push_back(&scene.closed(plan, 2));
  const std::vector<ParetoPlan> front = pareto_front(scene.evaluations, plans, 2);
  ASSERT_EQ(front.size(), 3u);
  EXPECT_EQ(plan_key(front[0].plan), plan_key(more));
  EXPECT_EQ(front[0].steps, 2);
  EXPECT_EQ(plan_key(front[1].plan), plan_key(lower));
  EXPECT_EQ(front[1].mean_mm2, 2.0);
  EXPECT_EQ(front[1].sd_mm2, 1.0);
  EXPECT_EQ(front[1].nodes, 2);
  EXPECT_TRUE(std::isnan(front[1].opening_mm2) && std::isnan(front[1].durability_mm));
  EXPECT_EQ(plan_key(front[2].plan), plan_key(milder));
}

TEST(ParetoFront, WhereWhatSomePlansTradeIsKnownItIsOfTheseAlone) {
  PlanEvaluationOptions options = on_threads(1);
  options.open = [](const Valve&) {
    PlanOpening opening;
    opening.measure.opening_area_mm2 = opening.measure.projected_area_mm2 = 300.0;
    return opening;
  };
  EvaluationScene scene(leak_of([](const Valve&) { return 0.5; }), std::move(options));
  PlanRecord* measured = &scene.evaluations.record(own_ring(2));
  ASSERT_TRUE(
      measure_trade_offs(scene.evaluations, {&measured, 1}, 2, PlanEvaluations::Phase::Searching));
  const std::vector<ParetoPlan> front =
      pareto_front(scene.evaluations, {&scene.closed(own_ring(1), 2), measured}, 2);
  ASSERT_EQ(front.size(), 1u);
  EXPECT_EQ(front[0].opening_mm2, 300.0);
  EXPECT_EQ(front[0].durability_mm, 12.0);
  EXPECT_EQ(front[0].cost, scene.evaluations.cost(*measured, 2));
}

}  // namespace
}  // namespace coapt::scene
