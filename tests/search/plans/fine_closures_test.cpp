#include "search/plans/fine_closures.h"

#include <cmath>

#include "core/closure/refined_start.h"
#include "core/repair/apply_plan.h"
#include "core/valve/refine.h"
#include "search/plans/ranking.h"
#include "tests/scenes/small_preset.h"
#include "tests/search/plans/search_scene.h"

namespace coapt::scene {
namespace {

/// The small valve has 32 faces; a finer one leaks `there`.
Evaluator leaking_on_fine_meshes(double here, double there) {
  return [here, there](const Valve& valve, const ClosureResult*) -> ClosedPlan {
    return {leaking(valve.faces.rows() > 32 ? there : here), nullptr};
  };
}

/// A plan that is tight over nine nodes of its own mesh.
RankedPlan ranked_with(const Evaluator& evaluate, int levels) {
  EvaluationScene scene(evaluate);
  PlanRecord& plan = scene.closed(suture(Side::Posteromedial, 20.0), 9);
  return rank(scene.evaluations, {&plan}, over_nodes(9),
              close_fine(scene.evaluations, {&plan}, levels))[0];
}

TEST(FineClosures, ClosePlansAndTheValveAsItIsOnTheRefinedMesh) {
  EvaluationScene scene(leaking_on_fine_meshes(0.0, 0.75));
  PlanRecord& plan = scene.closed(suture(Side::Posteromedial, 20.0), 1);
  const int before = scene.evaluations.closures();
  const FineClosures once = close_fine(scene.evaluations, {&plan}, 1);
  EXPECT_EQ(once.mesh.levels, 1);
  EXPECT_EQ(once.mesh.triangles, 4 * 32);
  EXPECT_EQ(once.mesh.closures, 2);
  EXPECT_EQ(once.plans.at(&plan).leak_mm2, 0.75);
  EXPECT_EQ(once.mesh.before->leak_mm2, 0.75);
  const FineClosures twice = close_fine(scene.evaluations, {&plan}, 2);
  EXPECT_EQ(twice.mesh.triangles, 16 * 32);
  EXPECT_EQ(twice.mesh.closures, 4) << "each level is closed";
  EXPECT_EQ(scene.evaluations.closures(), before) << "they are counted apart";
}

TEST(FineClosures, WhatIsKnownIsNotClosedAgain) {
  EvaluationScene scene(leaking_on_fine_meshes(0.0, 0.75));
  PlanRecord& ring = scene.closed(own_ring(1), 1);
  PlanRecord& tied = scene.closed(suture(Side::Posteromedial, 20.0), 1);
  FineClosures known = close_fine(scene.evaluations, {&ring}, 1);
  known.plans.at(&ring).leak_mm2 = 3.0;  // a mark
  const FineClosures both = close_fine(scene.evaluations, {&ring, &tied}, 1, known);
  EXPECT_EQ(both.plans.at(&ring).leak_mm2, 3.0);
  EXPECT_EQ(both.plans.at(&tied).leak_mm2, 0.75);
  EXPECT_EQ(both.mesh.closures, 3) << "each once";
}

TEST(FineClosures, NoneWithoutLevels) {
  EvaluationScene scene(leaking_on_fine_meshes(0.0, 0.75));
  PlanRecord& plan = scene.closed(suture(Side::Posteromedial, 20.0), 1);
  const FineClosures none = close_fine(scene.evaluations, {&plan}, 0);
  EXPECT_TRUE(none.plans.empty());
  EXPECT_FALSE(none.mesh.before);
  EXPECT_EQ(none.mesh.triangles, 0);
}

TEST(FineClosures, AMeshThatIsFineAlreadyIsNotRefined) {
  Valve fine = small_valve();
  for (int level = 0; level < 4; ++level) fine = *refine(fine);  // 8,192 triangles
  SearchMonitor monitor(0.0, nullptr);
  const Evaluator evaluate = leaking_on_fine_meshes(0.0, 0.75);
  PlanEvaluations evaluations(evaluate, fine, on_threads(1), monitor);
  EXPECT_EQ(close_fine(evaluations, {}, 2).mesh.levels, 0);
}

TEST(FineClosures, APlanIsAcceptableOnlyIfTheFineMeshSaysSo) {
  EXPECT_TRUE(ranked_with(leaking_on_fine_meshes(0.0, 0.9), 1).is_acceptable);
  const RankedPlan leaks = ranked_with(leaking_on_fine_meshes(0.0, 6.5), 1);
  EXPECT_FALSE(leaks.is_acceptable);
  EXPECT_EQ(leaks.warnings.back(),
            "on 128 triangles it leaks 6.5 mm², so the plan is not acceptable");
  EXPECT_TRUE(ranked_with(leaking_on_fine_meshes(0.0, 6.5), 0).is_acceptable);
}

TEST(FineClosures, ACancelledSearchMakesNoneAndCallsNothingAcceptable) {
  std::atomic<bool> cancelled = false;
  EvaluationScene scene(leaking_on_fine_meshes(0.0, 0.0), on_threads(1), &cancelled);
  PlanRecord& plan = scene.closed(suture(Side::Posteromedial, 20.0), 9);
  cancelled = true;
  const FineClosures fine = close_fine(scene.evaluations, {&plan}, 1);
  EXPECT_TRUE(fine.plans.empty());
  const RankedPlan ranked = rank(scene.evaluations, {&plan}, over_nodes(9), fine)[0];
  EXPECT_EQ(ranked.own_mesh_rank, 0);
  EXPECT_FALSE(ranked.is_acceptable);
}

TEST(FineClosures, OrderThePlansAndSayWhereTheyStoodBefore) {
  // On its own mesh the ring leaks 2 mm2 and the suture 4; on the finer one 8 and 1.
  const auto evaluate = [](const Valve& valve, const ClosureResult*) -> ClosedPlan {
    const bool ring = valve.annulus_mm.col(0).maxCoeff() < 17.5;
    const bool fine = valve.faces.rows() > 32;
    return {leaking(ring ? (fine ? 8.0 : 2.0) : (fine ? 1.0 : 4.0)), nullptr};
  };
  EvaluationScene scene(evaluate);
  PlanRecord& ring = scene.closed(own_ring(1), 9);
  PlanRecord& tied = scene.closed(suture(Side::Posteromedial, 27.0), 9);
  const FineClosures fine = close_fine(scene.evaluations, {&ring, &tied}, 1);
  const std::vector<RankedPlan> plans =
      rank(scene.evaluations, {&ring, &tied}, over_nodes(9), fine);
  EXPECT_EQ(plans[0].measure.leak.area_mm2, 4.0);
  EXPECT_EQ(plans[0].own_mesh_rank, 2);
  EXPECT_EQ(plans[1].own_mesh_rank, 1);
  EXPECT_EQ(plans[0].rank, 1);
  EXPECT_GT(plans[0].probability_outranks_next, 0.9) << "the finer mesh decides";
  // 2 more mm2 above 1 cost six each, without steps: 6 x (8 - 2).
  EXPECT_NEAR(price(fine_change(scene.evaluations, ring, fine), {}), 6.0 * 6.0, 1e-9);
  for (const RankedPlan& plan : plans)
    EXPECT_NEAR(price(plan.terms, {}), plan.cost + plan.fine_cost_change, 1e-9);
  EXPECT_EQ(rank(scene.evaluations, {&ring}, over_nodes(9), fine)[0].fine_cost_change,
            plans[1].fine_cost_change)
      << "it counts where more were closed than are ranked";
}

TEST(FineClosures, AreTheSameForAnyNumberOfThreads) {
  const Valve& valve = shared_preset("human-functional-mr", 150);
  const Evaluator evaluate = closing_evaluator({});
  std::vector<double> leaks;
  for (const int threads : {1, 3}) {
    SearchMonitor monitor(0.0, nullptr);
    PlanEvaluations evaluations(evaluate, valve, on_threads(threads), monitor);
    std::vector<PlanRecord*> plans;
    for (const int sizes : {1, 2, 3}) plans.push_back(&evaluations.record(own_ring(sizes)));
    for (PlanRecord* plan : plans) evaluations.close_here(*plan, 1);
    const FineClosures fine = close_fine(evaluations, plans, 1);
    for (PlanRecord* plan : plans) leaks.push_back(fine.plans.at(plan).leak_mm2);
  }
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(leaks[i], leaks[i + 3]);
}

TEST(FineClosures, APlanMeansTheSameAppliedBeforeOrAfterRefinement) {
  const Valve& valve = shared_preset("human-functional-mr");
  const RepairPlan plan = {
      {Annuloplasty{CatalogueRing{"generic-classic", 32.0}},
       PapillaryApproximation{.side = Side::Posteromedial, .suture_length_mm = 24.0},
       Neochorda{"PM1", {Leaflet::Posterior, 0.6, 0.9}, 22.0}}};
  const Valve before = *refine(*apply_plan(valve, plan)), after = *apply_plan(*refine(valve), plan);
  EXPECT_LT((before.annulus_mm - after.annulus_mm).rowwise().norm().maxCoeff(), 0.1);
  for (std::size_t h = 0; h < before.heads.size(); ++h)
    EXPECT_LT((before.heads[h].tip_mm - after.heads[h].tip_mm).norm(), 0.1);
  const auto end = [](const Valve& repaired) {
    return position(repaired.chordae.back().segments.back().insertion, repaired.faces,
                    repaired.rest_mm);
  };
  EXPECT_LT((end(before) - end(after)).norm(), 0.3);
}

}  // namespace
}  // namespace coapt::scene
