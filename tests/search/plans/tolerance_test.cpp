#include "search/plans/tolerance.h"

#include <array>
#include <limits>

#include "core/repair/apply_plan.h"
#include "core/repair/approximation.h"
#include "tests/search/plans/search_scene.h"

namespace coapt::scene {
namespace {

constexpr double kFailed = std::numeric_limits<double>::quiet_NaN();

ToleranceCurve curve(std::vector<double> error_mm, std::vector<double> leak_mm2) {
  return with_margin(
      {0, StepError::SutureLength, std::move(error_mm), std::move(leak_mm2), 0.0, true});
}

TEST(Tolerance, TheMarginIsWhereTheLeakPassesOneBetweenTwoClosures) {
  const ToleranceCurve leaking = curve({-2, -1, 0, 1, 2}, {9.0, 0.6, 0.4, 0.6, 2.6});
  EXPECT_DOUBLE_EQ(leaking.margin_mm, 1.0 + 0.4 / 8.4);  // shorter; longer at 1.2
  EXPECT_TRUE(leaking.leaks_beyond);
  const ToleranceCurve tight = curve({-3, -2, 0, 1}, {0.0, 0.0, 0.0, 0.9});
  EXPECT_DOUBLE_EQ(tight.margin_mm, 1.0) << "as far as both sides were closed";
  EXPECT_FALSE(tight.leaks_beyond);
  EXPECT_EQ(curve({-1, 0, 1}, {0.0, 1.1, 0.0}).margin_mm, 0.0);
}

TEST(Tolerance, AFailedClosureEndsTheMarginAndAMissingSideDoesNotLimitIt) {
  EXPECT_DOUBLE_EQ(curve({0, 1, 2, 3}, {0.0, 0.0, kFailed, 0.0}).margin_mm, 1.0);
  const ToleranceCurve one_sided = curve({-3, -2, -1, 0}, {0.5, 0.4, 0.3, 0.2});
  EXPECT_DOUBLE_EQ(one_sided.margin_mm, 3.0);
  EXPECT_FALSE(one_sided.leaks_beyond);
}

/// 150 triangles; its tips are displaced.
struct RealScene {
  const Valve& valve = shared_preset("human-functional-mr", 150);
  Evaluator evaluate = closing_evaluator({});
  SearchMonitor monitor{0.0, nullptr};
  PlanEvaluations evaluations{evaluate, valve, on_threads(2), monitor};

  std::vector<ToleranceCurve> tolerances(const RepairPlan& plan) {
    PlanRecord& record = evaluations.record(plan);
    EXPECT_TRUE(record.possible);
    EXPECT_TRUE(evaluations.close(std::array{PlanEvaluations::Wanted{&record, 0}},
                                  PlanEvaluations::Phase::Ranking));
    return step_tolerances(evaluations, record);
  }
};

/// Taut by so much.
RepairPlan ring_and_suture(const Valve& valve, double moved_mm) {
  RepairPlan plan = own_ring(1);
  const Valve ringed = *apply_plan(valve, plan);
  PapillaryApproximation suture{.side = Side::Posteromedial};
  suture.suture_length_mm = anchor_distance_mm(ringed, suture) - moved_mm;
  plan.steps.emplace_back(suture);
  return plan;
}

TEST(Tolerance, EachStepIsOffAloneAndWhatIsImpossibleIsLeftOut) {
  RealScene scene;
  const RepairPlan plan = ring_and_suture(scene.valve, 1.5);
  const std::vector<ToleranceCurve> curves = scene.tolerances(plan);
  const int closures = scene.evaluations.closures();
  ASSERT_EQ(curves.size(), 3U);
  EXPECT_EQ(curves[0].error, StepError::RingSize);
  EXPECT_EQ(curves[0].error_mm, (std::vector<double>{-6, -4, -2, 0, 2}))
      << "own rings: size 0 at most";
  EXPECT_EQ(curves[1].error, StepError::SutureLength);
  EXPECT_EQ(curves[1].error_mm, (std::vector<double>{-3, -2, -1, 0, 1})) << "slack from 1.5 mm on";
  EXPECT_EQ(curves[1].step, 1);
  EXPECT_EQ(curves[2].error, StepError::SutureAnchor);
  EXPECT_EQ(closures, 2) << "of the valve and of the plan: nothing counts the others";

  RepairPlan longer = plan;
  std::get<PapillaryApproximation>(longer.steps[1]).suture_length_mm += 1.0;
  const Valve repaired = *apply_plan(scene.valve, longer);
  const ClosedPlan cold = with_leak_surface(repaired, scene.evaluate(repaired, nullptr));
  EXPECT_NEAR(curves[1].leak_mm2.back(), cold.evaluation.measure.leak.area_mm2, 0.5);
  EXPECT_LE(curves[1].leak_mm2.front(), curves[1].leak_mm2.back()) << "the shorter the tighter";
}

TEST(Tolerance, AStitchMovesByMillimetresOnTheLeafletAndNotBeyondItsEdge) {
  RealScene scene;
  const Neochorda neochorda{scene.valve.heads.front().id, {Leaflet::Posterior, 0.5, 1.0}, 25.0};
  const std::vector<ToleranceCurve> curves = scene.tolerances({{neochorda}});
  ASSERT_EQ(curves.size(), 3U);
  EXPECT_EQ(curves[0].error, StepError::NeochordaLength);
  EXPECT_EQ(curves[0].error_mm.size(), 7U);
  EXPECT_EQ(curves[1].error, StepError::StitchAlongLeaflet);
  EXPECT_EQ(curves[1].error_mm.size(), 7U);
  EXPECT_EQ(curves[2].error, StepError::StitchTowardsEdge);
  EXPECT_EQ(curves[2].error_mm, (std::vector<double>{-3, -2, -1, 0}));
}

TEST(Tolerance, OfRealClosuresIsTheSameForAnyNumberOfThreads) {
  const RepairPlan plan = ring_and_suture(shared_preset("human-functional-mr", 150), 4.0);
  expect_same_on_any_threads([&plan](PlanEvaluations& evaluations) {
    PlanRecord& record = evaluations.record(plan);
    EXPECT_TRUE(evaluations.close(std::array{PlanEvaluations::Wanted{&record, 0}},
                                  PlanEvaluations::Phase::Ranking));
    std::vector<double> leaks;
    for (const ToleranceCurve& curve : step_tolerances(evaluations, record))
      leaks.insert(leaks.end(), curve.leak_mm2.begin(), curve.leak_mm2.end());
    return leaks;
  });
}

TEST(Tolerance, ASearchSaysItOfTheFirstPlanWithTheEvidence) {
  const Evaluator kept = [](const Valve& valve, const ClosureResult* from) {
    ClosedPlan closed = needs_suture(valve, from);
    auto closure = std::make_shared<ClosureResult>();
    closure->status = ClosureStatus::Converged;
    closure->closed_mm = valve.rest_mm;
    closed.closure = std::move(closure);
    return closed;
  };
  SearchOptions options = small_search();
  options.evaluations = 20;
  options.plans = 2;
  EXPECT_TRUE(searched(kept, options).plans.at(0).tolerance.empty());
  options.evidence = true;
  const SearchResult result = searched(kept, options);
  EXPECT_FALSE(result.plans.at(0).tolerance.empty());
  EXPECT_TRUE(result.plans.at(1).tolerance.empty());
  EXPECT_TRUE(searched(needs_suture, options).plans.at(0).tolerance.empty()) << "without closures";
}

}  // namespace
}  // namespace coapt::scene
