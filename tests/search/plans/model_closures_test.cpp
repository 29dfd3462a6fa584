#include "search/plans/model_closures.h"

#include <cmath>

#include "core/presets/synthetic_chordae.h"
#include "search/plans/ranking.h"
#include "search/plans/search_result.h"
#include "tests/scenes/small_preset.h"
#include "tests/search/plans/search_scene.h"

namespace coapt::scene {
namespace {

constexpr int kDraws = 8;

/// leak(whether there is a ring, stiffness of the draw).
template <class Leak>
Evaluator ring_or_suture(Leak leak) {
  return [leak](const Valve& valve, const ClosureResult*) -> ClosedPlan {
    return {leaking(leak(has_ring(valve), stiffness(valve))), nullptr};
  };
}

/// The ring and the suture over nine nodes.
struct TwoPlans {
  explicit TwoPlans(const Evaluator& evaluate)
      : scene(evaluate),
        ring(&scene.closed(own_ring(1), 9)),
        tied(&scene.closed(suture(Side::Posteromedial, 27.0), 9)) {}
  std::vector<RankedPlan> ranked(int draws) {
    const std::vector<PlanRecord*> plans = {ring, tied};
    return rank(scene.evaluations, plans, over_nodes(9), {},
                close_under_draws(scene.evaluations, plans, draws));
  }
  EvaluationScene scene;
  PlanRecord *ring, *tied;
};

TEST(ModelClosures, ClosePlansAndTheValveAsItIsUnderTheSameDraws) {
  EvaluationScene scene(leak_of([](const Valve& valve) { return stiffness(valve); }));
  PlanRecord& plan = scene.closed(suture(Side::Posteromedial, 20.0), 1);
  const int before = scene.evaluations.closures();
  const ModelClosures model = close_under_draws(scene.evaluations, {&plan}, kDraws);
  EXPECT_EQ(model.closures, 2 * kDraws);
  ASSERT_EQ(model.before.size(), static_cast<std::size_t>(kDraws));
  for (int draw = 0; draw < kDraws; ++draw)
    EXPECT_EQ(model.plans.at(&plan)[draw].leak_mm2, model.before[draw].leak_mm2);
  EXPECT_EQ(scene.evaluations.closures(), before) << "they are counted apart";
  const ModelSpread spread = model_spread(model.plans.at(&plan));
  EXPECT_EQ(spread.draws, kDraws);
  EXPECT_EQ(spread.failures, 0);
  EXPECT_GT(spread.sd_mm2, 0.0);
  EXPECT_GT(spread.worst_mm2, spread.mean_mm2);
}

TEST(ModelClosures, AddedPlansAreClosedInTheSameDrawsAndNothingTwice) {
  EvaluationScene scene(leak_of([](const Valve& valve) { return stiffness(valve); }));
  PlanRecord& ring = scene.closed(own_ring(1), 1);
  PlanRecord& tied = scene.closed(suture(Side::Posteromedial, 20.0), 1);
  const ModelClosures added =
      close_under_draws(scene.evaluations, {&ring, &tied}, kDraws,
                        close_under_draws(scene.evaluations, {&ring}, kDraws));
  const ModelClosures at_once = close_under_draws(scene.evaluations, {&ring, &tied}, kDraws);
  EXPECT_EQ(added.closures, 3 * kDraws);
  EXPECT_EQ(at_once.closures, 3 * kDraws);
  for (const PlanRecord* plan : {&ring, &tied})
    for (int draw = 0; draw < kDraws; ++draw)
      EXPECT_EQ(added.plans.at(plan)[draw].leak_mm2, at_once.plans.at(plan)[draw].leak_mm2);
}

TEST(ModelClosures, ChordaeThatWereNeverSeenAreDrawnAnewAlikeForAllPlans) {
  const Valve valve =
      *with_synthetic_chordae(shared_preset("human-functional-mr", 150), 1, Points(0, 3));
  const auto chordae = [](const Valve& of) { return static_cast<double>(of.chordae.size()); };
  const Evaluator evaluate = leak_of(chordae);
  SearchMonitor monitor(0.0, nullptr);
  PlanEvaluations evaluations(evaluate, valve, on_threads(2), monitor);
  PlanRecord& ring = evaluations.record(own_ring(1));
  const std::vector<PlanEvaluations::Wanted> wanted = {{&ring, 0}};
  ASSERT_TRUE(evaluations.close(wanted, PlanEvaluations::Phase::Ranking));
  const ModelClosures model = close_under_draws(evaluations, {&ring}, kDraws);
  int other = 0;
  for (int draw = 0; draw < kDraws; ++draw) {
    const Expected<Valve> redrawn = redrawn_chordae(valve, 2 + draw);
    ASSERT_TRUE(redrawn);
    EXPECT_EQ(model.before[draw].leak_mm2, chordae(*redrawn));
    EXPECT_EQ(model.plans.at(&ring)[draw].leak_mm2, model.before[draw].leak_mm2);
    other += model.before[draw].leak_mm2 != chordae(valve) ? 1 : 0;
  }
  EXPECT_GT(other, 0);
}

/// The valve leaks 10 mm2 times the stiffness of its chordae, a tenth of it with a ring.
Evaluator by_stiffness() {
  return ring_or_suture(
      [](bool ring, double stiffness) { return (ring ? 1.0 : 10.0) * stiffness; });
}

TEST(ModelClosures, DrawsArePickedAsTheyAgreeWithWhatWasObserved) {
  Valve valve = small_valve();
  valve.observed = {{ObservedFigure::Leak, 20.0, 2.0, ""}};
  const Evaluator evaluate = by_stiffness();
  SearchMonitor monitor(0.0, nullptr);
  PlanEvaluations evaluations(evaluate, valve, on_threads(2), monitor);
  PlanRecord& ring = evaluations.record(own_ring(1));
  const std::vector<PlanEvaluations::Wanted> wanted = {{&ring, 0}};
  ASSERT_TRUE(evaluations.close(wanted, PlanEvaluations::Phase::Ranking));
  const ModelClosures model = close_under_draws(evaluations, {&ring}, kDraws);
  EXPECT_EQ(model.draws, kConditionedDraws);
  EXPECT_FALSE(model.contradicts);
  EXPECT_GT(model.effective, 1.0);
  EXPECT_LE(model.effective, model.pool);
  ASSERT_EQ(std::ssize(model.before), kConditionedDraws);
  for (int draw = 0; draw < kConditionedDraws; ++draw) {
    EXPECT_NEAR(model.before[draw].leak_mm2, 20.0, 8.0);
    EXPECT_NEAR(model.plans.at(&ring)[draw].leak_mm2, 0.1 * model.before[draw].leak_mm2, 1e-9);
  }
}

TEST(ModelClosures, AreNoMoreThanWasSaid) {
  Valve valve = small_valve();
  const Evaluator evaluate = by_stiffness();
  for (const bool observed : {false, true}) {
    if (observed) valve.observed = {{ObservedFigure::Leak, 500.0, 2.0, ""}};  // no draw agrees
    SearchMonitor monitor(0.0, nullptr);
    PlanEvaluations evaluations(evaluate, valve, on_threads(1), monitor);
    PlanRecord& ring = evaluations.record(own_ring(1));
    const std::vector<PlanEvaluations::Wanted> wanted = {{&ring, 0}};
    ASSERT_TRUE(evaluations.close(wanted, PlanEvaluations::Phase::Ranking));
    EXPECT_EQ(close_under_draws(evaluations, {&ring}, kDraws).closures,
              most_draw_closures(valve, 1, kDraws));
    EXPECT_EQ(most_draw_closures(valve, 1, 0), 0);
  }
}

TEST(ModelClosures, WhatWasObservedMayContradictTheModel) {
  Valve valve = small_valve();
  valve.observed = {{ObservedFigure::Leak, 500.0, 2.0, ""}};
  const Evaluator evaluate = by_stiffness();
  SearchMonitor monitor(0.0, nullptr);
  PlanEvaluations evaluations(evaluate, valve, on_threads(1), monitor);
  const ModelClosures model = close_under_draws(evaluations, {}, kDraws);
  EXPECT_TRUE(model.contradicts);
  EXPECT_EQ(model.pool, kConditionedDraws * kMostBlocks);
  EXPECT_EQ(std::ssize(model.before), kConditionedDraws);
}

TEST(ModelClosures, SpreadIsOfTrustedClosuresAlone) {
  PlanClosure failed = closure_leaking(100.0);
  failed.crossing = true;
  const ModelSpread spread = model_spread({closure_leaking(1.0), failed, closure_leaking(3.0)});
  EXPECT_EQ(spread.failures, 1);
  EXPECT_EQ(spread.mean_mm2, 2.0);
  EXPECT_DOUBLE_EQ(spread.sd_mm2, std::sqrt(2.0));
  EXPECT_EQ(spread.worst_mm2, 3.0);
  EXPECT_TRUE(std::isnan(model_spread({failed}).mean_mm2));
}

TEST(ModelClosures, WithoutDrawsNothingIsSaid) {
  TwoPlans two(ring_or_suture([](bool ring, double) { return ring ? 10.0 : 30.0; }));
  for (const RankedPlan& plan : two.ranked(0)) EXPECT_FALSE(plan.model);
}

TEST(ModelClosures, APlanThatLeaksUnderTheDrawsIsNotAcceptable) {
  // Both are tight; the suture no longer is on any other material.
  TwoPlans two(
      ring_or_suture([](bool ring, double stiff) { return !ring && stiff != 1.0 ? 30.0 : 0.0; }));
  for (const RankedPlan& plan : two.ranked(0)) EXPECT_TRUE(plan.is_acceptable);
  const std::vector<RankedPlan> plans = two.ranked(kDraws);
  ASSERT_TRUE(std::holds_alternative<Annuloplasty>(plans[0].plan.steps[0]));
  EXPECT_TRUE(plans[0].is_acceptable);
  EXPECT_FALSE(plans[1].is_acceptable);
  EXPECT_LT(plans[1].acceptable_probability, 0.1);
  EXPECT_GT(plans[0].probability_outranks_next, 0.99);
}

TEST(ModelClosures, DrawsInWhichAClosureFailsCountAgainstThePlan) {
  TwoPlans two([](const Valve& valve, const ClosureResult*) -> ClosedPlan {
    Evaluation evaluation = leaking(0.0);
    evaluation.crossing = has_ring(valve) && stiffness(valve) > 1.0;
    return {evaluation, nullptr};
  });
  const std::vector<RankedPlan> plans = two.ranked(kDraws);
  ASSERT_TRUE(std::holds_alternative<PapillaryApproximation>(plans[0].plan.steps[0]));
  const RankedPlan& ring = plans[1];
  EXPECT_GT(ring.model->failures, 0);
  EXPECT_LT(ring.model->failures, kDraws);
  const double closed = 1.0 - static_cast<double>(ring.model->failures) / kDraws;
  EXPECT_NEAR(ring.acceptable_probability, closed * plans[0].acceptable_probability, 1e-9);
}

TEST(ModelClosures, ACancelledSearchMakesNone) {
  std::atomic<bool> cancelled = false;
  EvaluationScene scene(leak_of([](const Valve&) { return 2.0; }), on_threads(1), &cancelled);
  PlanRecord& plan = scene.closed(suture(Side::Posteromedial, 20.0), 9);
  cancelled = true;
  const ModelClosures model = close_under_draws(scene.evaluations, {&plan}, kDraws);
  EXPECT_EQ(model.closures, 0);
  EXPECT_TRUE(model.plans.empty());
  EXPECT_FALSE(rank(scene.evaluations, {&plan}, over_nodes(9), {}, model)[0].model);
}

TEST(ModelClosures, AreTheSameForAnyNumberOfThreads) {
  expect_same_on_any_threads([](PlanEvaluations& evaluations) {
    std::vector<PlanRecord*> plans;
    for (const int sizes : {1, 2}) plans.push_back(&evaluations.record(own_ring(sizes)));
    for (PlanRecord* plan : plans) evaluations.close_here(*plan, 1);
    const ModelClosures model = close_under_draws(evaluations, plans, 4);
    std::vector<double> leaks;
    for (PlanRecord* plan : plans)
      for (const PlanClosure& closure : model.plans.at(plan)) leaks.push_back(closure.leak_mm2);
    return leaks;
  });
}

}  // namespace
}  // namespace coapt::scene
