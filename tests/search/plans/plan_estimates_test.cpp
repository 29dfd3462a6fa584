#include "search/plans/plan_estimates.h"

#include <cmath>

#include "core/metrics/area_error.h"
#include "core/metrics/figure_error.h"
#include "tests/search/plans/search_scene.h"

namespace coapt::scene {
namespace {

PlanClosure closed(double leak_mm2, double coaptation_mm, double tension_max_n) {
  PlanClosure closure = closure_leaking(leak_mm2);
  closure.coaptation_mm = coaptation_mm;
  closure.tension_max_n = tension_max_n;
  return closure;
}

ValveMeasure measured(double leak_mm2) {
  ValveMeasure measure;
  measure.leak.area_mm2 = leak_mm2;
  measure.leak_error_mm2 = 1.0;
  return measure;
}

/// A plan closed at nine nodes, whose leak is 3 mm2 where the search estimates 2, each node 0.5 mm2, 0.25 mm and 0.125 N further.
struct ClosedNodes {
  ClosedNodes()
      : scene(leak_of([](const Valve&) { return 2.0; })), plan(scene.closed(own_ring(1), 1)) {
    for (int node = 0; node < 9; ++node)
      plan.closures[node] = closed(2.0 + 0.5 * node, 4.0 - 0.25 * node, 1.0 + 0.125 * node);
  }
  PlanEstimates estimates(const FineClosures& fine = {}, const ModelClosures& model = {}) const {
    return plan_estimates(scene.evaluations, plan, measured(3.0), 9, fine, model);
  }
  EvaluationScene scene;
  PlanRecord& plan;
};

TEST(PlanEstimates, ExecutionIsWhatTheNodesOfTheRegionChange) {
  const PlanEstimates known = ClosedNodes().estimates();
  EXPECT_EQ(known.leak_mm2.value, 3.0);
  EXPECT_EQ(known.leak_mm2.numerical, (Interval{2.0, 4.0}));
  // Of so few values the interval is all of them (predicted_quantile).
  EXPECT_NEAR(known.leak_mm2.execution->low, 3.0, 1e-9);
  EXPECT_NEAR(known.leak_mm2.execution->high, 3.0 + 4.0, 1e-9);
  EXPECT_EQ(known.coaptation_mm.value, 4.0);
  EXPECT_NEAR(known.coaptation_mm.execution->low, 4.0 - 2.0, 1e-9);
  EXPECT_EQ(known.tension_max_n.value, 1.0);
  EXPECT_NEAR(known.tension_max_n.execution->high, 1.0 + 1.0, 1e-9);
  EXPECT_FALSE(known.leak_mm2.tissue);
  EXPECT_FALSE(known.tension_max_n.tissue);
}

TEST(PlanEstimates, TissueIsWhatTheDrawsChangeUnlessTheyAreContradicted) {
  const ClosedNodes nodes;
  ModelClosures model;
  for (int draw = 0; draw < 5; ++draw)
    model.plans[&nodes.plan].push_back(closed(2.0 * draw, 4.0, 1.0 + draw));
  model.plans[&nodes.plan].push_back(closed(std::nan(""), 40.0, 40.0));
  const PlanEstimates known = nodes.estimates({}, model);
  EXPECT_NEAR(known.leak_mm2.tissue->low, 1.0, 1e-9);
  EXPECT_NEAR(known.leak_mm2.tissue->high, 1.0 + 8.0, 1e-9);
  EXPECT_EQ(known.coaptation_mm.tissue, (Interval{4.0, 4.0}));
  EXPECT_NEAR(known.tension_max_n.tissue->high, 1.0 + 4.0, 1e-9);
  model.contradicts = true;
  EXPECT_FALSE(nodes.estimates({}, model).tension_max_n.tissue);
}

TEST(PlanEstimates, LeaksOfDrawsThatAreMeasuredAreNotShifted) {
  const ClosedNodes nodes;
  ModelClosures model;
  for (int draw = 0; draw < 5; ++draw) {
    model.plans[&nodes.plan].push_back(closed(2.0 * draw, 4.0, 1.0));
    model.measured[&nodes.plan].push_back(closed(2.5 * draw, 4.0, 1.0));
  }
  const Interval tissue = *nodes.estimates({}, model).leak_mm2.tissue;
  EXPECT_NEAR(tissue.low, 0.0, 1e-9);
  EXPECT_NEAR(tissue.high, 10.0, 1e-9);
}

TEST(PlanEstimates, TheLeafletRatioIsKnownWhereTheLeafletsTouch) {
  const ClosedNodes nodes;
  EXPECT_TRUE(std::isnan(nodes.estimates().leaflet_ratio.value));
  EXPECT_FALSE(nodes.estimates().leaflet_ratio.execution);
  for (int node = 0; node < 6; ++node) nodes.plan.closures[node].leaflet_ratio = 1.5 + 0.1 * node;
  const Estimate ratio = nodes.estimates().leaflet_ratio;
  EXPECT_EQ(ratio.value, 1.5);
  EXPECT_LT(ratio.numerical->low, 1.5);
  EXPECT_NEAR(ratio.execution->high, 2.0, 1e-9) << "three nodes do not say";
  EXPECT_TRUE(nodes.estimates().strain_radial.numerical);
}

TEST(PlanEstimates, TheNumericalErrorIsAboutTheFinerMeshWhereItWasClosedOnOne) {
  const ClosedNodes nodes;
  FineClosures fine;
  fine.mesh.levels = 1;
  fine.mesh.triangles = 2600;
  fine.plans[&nodes.plan] = closed(2.5, 3.75, 1.25);
  const PlanEstimates known = nodes.estimates(fine);
  EXPECT_EQ(known.leak_mm2.numerical, area_interval(2.5, area_error_mm2(2.5, {.triangles = 2600})));
  EXPECT_EQ(known.coaptation_mm.numerical, figure_interval(Figure::Coaptation, 3.75, 2600));
  EXPECT_EQ(known.tension_max_n.numerical, figure_interval(Figure::Tension, 1.25, 2600));
  fine.plans[&nodes.plan].crossing = true;
  EXPECT_EQ(nodes.estimates(fine).tension_max_n.numerical,
            nodes.estimates().tension_max_n.numerical);
}

TEST(PlanEstimates, OfAnOpeningAndOfDurabilityTheNumericalErrorIsKnownAtOnce) {
  ClosedNodes nodes;
  EXPECT_TRUE(std::isnan(nodes.estimates().opening_mm2.value));
  EXPECT_TRUE(std::isnan(nodes.estimates().durability_mm.value));
  nodes.plan.opening = PlanOpening{ClosureStatus::Converged, false, {320.0, 300.0, 700.0, 1.9}};
  const PlanEstimates known = nodes.estimates();
  EXPECT_EQ(known.opening_mm2.value, 320.0);
  EXPECT_EQ(known.gradient_mmhg.value, 1.9);
  EXPECT_LT(known.gradient_mmhg.numerical->low, 1.9);
  EXPECT_FALSE(known.opening_mm2.execution);
  nodes.plan.opening->crossing = true;
  EXPECT_TRUE(std::isnan(nodes.estimates().gradient_mmhg.value));
}

TEST(PlanEstimates, TissueAndHandSpreadTheOpeningsThatAreToBeTrusted) {
  const PlanOpening own{ClosureStatus::Converged, false, {.opening_area_mm2 = 320.0}};
  DrawnOpenings drawn;
  for (int draw = 0; draw < 5; ++draw) {
    drawn.draws.push_back(own);
    drawn.draws.back().measure.opening_area_mm2 = 300.0 + 10.0 * draw;
  }
  drawn.draws.push_back(own);
  drawn.draws.back().measure.opening_area_mm2 = 900.0;
  drawn.draws.back().crossing = true;
  drawn.errors.assign(4, own);  // too few
  PlanEstimates known;
  add_spread(known, own, drawn);
  EXPECT_NEAR(known.opening_mm2.tissue->low, 300.0, 1e-9);
  EXPECT_NEAR(known.opening_mm2.tissue->high, 340.0, 1e-9);
  EXPECT_FALSE(known.opening_mm2.execution);
  EXPECT_FALSE(known.tension_max_n.tissue);
  PlanOpening crossed = own;
  crossed.crossing = true;
  PlanEstimates unknown;
  add_spread(unknown, crossed, drawn);
  EXPECT_FALSE(widest(unknown.opening_mm2));
}

TEST(PlanEstimates, NothingIsKnownOfTheErrorOfAClosureThatIsNotToBeTrusted) {
  ClosedNodes nodes;
  nodes.plan.closures[0].crossing = true;
  const PlanEstimates known = nodes.estimates();
  EXPECT_EQ(known.tension_max_n.value, 1.0);
  EXPECT_FALSE(widest(known.tension_max_n));
  EXPECT_FALSE(widest(known.coaptation_mm));
}

TEST(FigureError, FallsWithTheMeshAndReachesNotBelowNothing) {
  const Interval coarse = *figure_interval(Figure::Opening, 300.0, 650);
  const Interval fine = *figure_interval(Figure::Opening, 300.0, 2600);
  EXPECT_NEAR(fine.high - 300.0, 0.25 * (coarse.high - 300.0), 1e-9);
  EXPECT_DOUBLE_EQ(300.0 - fine.low, fine.high - 300.0);
  EXPECT_EQ(figure_interval(Figure::Coaptation, 0.0, 650)->low, 0.0);
  EXPECT_GT(figure_interval(Figure::Coaptation, 0.0, 650)->high, 0.0);
  EXPECT_FALSE(figure_interval(Figure::Tension, std::nan(""), 650));
}

}  // namespace
}  // namespace coapt::scene
