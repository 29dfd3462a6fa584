#include "search/plans/plan_opening.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/metrics/area_error.h"
#include "core/repair/apply_plan.h"
#include "search/plans/durability.h"
#include "search/plans/pareto.h"
#include "search/plans/ranking.h"
#include "tests/search/plans/search_scene.h"

namespace coapt::scene {
namespace {

PlanOpening opening(double mm2, double mmhg) {
  PlanOpening made;
  made.measure.opening_area_mm2 = mm2;
  made.measure.projected_area_mm2 = mm2 - 50.0;  // hides what a tilted funnel leaves open
  made.measure.gradient_mmhg = mmhg;
  return made;
}

std::vector<GateSeverity> severities(const std::optional<PlanOpening>& of) {
  std::vector<GateSeverity> all;
  for (const Gate& gate : opening_gates(of)) {
    EXPECT_FALSE(gate.finding.empty());
    all.push_back(gate.severity);
  }
  return all;
}

TEST(PlanOpening, GatesRejectBelowOneAndAHalfAndWarnBelowTwoSquareCentimetres) {
  using enum GateSeverity;
  EXPECT_EQ(severities(opening(200.0, 5.0)), (std::vector{Pass, Pass}));
  EXPECT_EQ(severities(opening(199.0, 5.1)), (std::vector{Warn, Warn}));
  EXPECT_EQ(severities(opening(149.0, 7.6)), (std::vector{Reject, Warn}));
  EXPECT_TRUE(is_stenotic(opening(149.0, 7.6)));
  EXPECT_FALSE(is_stenotic(opening(150.0, 7.5)));
}

TEST(PlanOpening, IsNotAssessedWhereTheOpenValveDidNotComeToRest) {
  using enum GateSeverity;
  PlanOpening unsettled = opening(100.0, 9.0);
  unsettled.status = ClosureStatus::StepLimit;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const std::optional<PlanOpening>& none :
       {std::optional<PlanOpening>{}, std::optional(unsettled), std::optional(opening(nan, nan))}) {
    EXPECT_EQ(severities(none), (std::vector{NotAssessed, NotAssessed}));
    EXPECT_FALSE(is_stenotic(none));
  }
  EXPECT_EQ(price(opening_terms(unsettled), {}), 0.0);
}

TEST(PlanOpening, IsNotKnownBehindAClipAndRejectsNothing) {
  using enum GateSeverity;
  const RepairPlan clip{{EdgeToEdge{EdgeDevice::Clip, 0.5, 6.0}}};
  const PlanOpening unknown = open_plan(*apply_plan(fitting_valve(), clip));
  EXPECT_EQ(severities(unknown), (std::vector{NotAssessed, NotAssessed}));
  EXPECT_EQ(opening_gates(unknown)[0].finding,
            "the opening is not known where a clip or stitch leaves two orifices");
  EXPECT_FALSE(is_stenotic(unknown));
  EXPECT_EQ(price(opening_terms(unknown), {}), 0.0);
  EXPECT_FALSE(open_plan(fitting_valve()).two_orifices);

  PlanEvaluationOptions options = on_threads(1);
  options.open = open_plan;
  EvaluationScene scene(leak_of([](const Valve&) { return 0.5; }), std::move(options));
  PlanRecord* plan = &scene.closed(clip, 2);
  ASSERT_TRUE(scene.evaluations.open({&plan, 1}, PlanEvaluations::Phase::Searching));
  EXPECT_EQ(rank(scene.evaluations, {plan}, over_nodes(2))[0].warnings,
            std::vector<std::string>{kUnknownOpening});
}

TEST(PlanOpening, PriceRisesAboveThreeMmhgAndFasterAboveFive) {
  const CostWeights weights;  // 2 and 10 mm2 per mmHg
  EXPECT_EQ(price(opening_terms(opening(300.0, 3.0)), weights), 0.0);
  EXPECT_DOUBLE_EQ(price(opening_terms(opening(200.0, 4.0)), weights), 2.0);
  EXPECT_DOUBLE_EQ(price(opening_terms(opening(180.0, 6.0)), weights), 6.0 + 10.0);
}

TEST(PlanOpening, CountsInTheCostFromTheSecondNodeOn) {
  PlanEvaluationOptions options = on_threads(1);
  int opened = 0;
  options.open = [&opened](const Valve&) {
    ++opened;
    return opening(200.0, 4.0);
  };
  EvaluationScene scene(needs_suture, std::move(options));
  PlanRecord& plan = scene.closed(suture(Side::Anterolateral, 20.0), 5);
  const double one = scene.evaluations.cost(plan, 1), five = scene.evaluations.cost(plan, 5);
  std::vector<PlanRecord*> plans = {&plan, &plan};
  EXPECT_TRUE(scene.evaluations.open(plans, PlanEvaluations::Phase::Searching));
  EXPECT_TRUE(scene.evaluations.open(plans, PlanEvaluations::Phase::Searching));
  EXPECT_EQ(opened, 1);
  EXPECT_EQ(scene.evaluations.cost(plan, 1), one);
  EXPECT_DOUBLE_EQ(scene.evaluations.cost(plan, 5), five + 2.0);
}

TEST(PlanOpening, ASearchLeavesANarrowRingWhereAWiderOneClosesAsWell) {
  // Competent with any ring; those of three sizes below and more open too little.
  const Evaluator closes = [](const Valve& valve, const ClosureResult*) {
    const bool ring = ring_sizes_below(fitting_valve(), valve) > 0.5;
    return ClosedPlan{leaking(ring ? 0.0 : 20.0), nullptr};
  };
  SearchContext context = context_of(closes);
  context.open = [](const Valve& valve) {
    const double below = ring_sizes_below(fitting_valve(), valve);
    return below > 2.5 ? opening(140.0, 8.0) : opening(300.0, 1.9);
  };
  const SearchResult result = searched(small_search(), context);
  ASSERT_FALSE(result.plans.empty());
  EXPECT_FALSE(is_stenotic(result.plans[0].opening));
  EXPECT_TRUE(result.plans[0].opening.has_value());
  EXPECT_TRUE(result.opening_before.has_value());
  for (std::size_t i = 1; i < result.plans.size(); ++i)
    EXPECT_LE(is_stenotic(result.plans[i - 1].opening), is_stenotic(result.plans[i].opening));
}

/// Closures of the courses of disease: `mm2` of leak each millimetre.
PlanRecord leaking_by(double mm2) {
  PlanRecord record;
  for (const DiseaseCourse& course : disease_courses())
    for (std::size_t step = 0; step < course.indices.size(); ++step)
      record.closures[course.indices[step]] =
          closure_leaking(mm2 * kCourseStep_mm * static_cast<double>(step));
  return record;
}

TEST(Durability, IsTheWayToFiveSquareMillimetresOfLeak) {
  EXPECT_DOUBLE_EQ(durability(leaking_by(2.0))->expected_mm, 2.5);
  EXPECT_EQ(durability(leaking_by(2.0))->outlasting, 0.0);
  EXPECT_DOUBLE_EQ(durability(leaking_by(0.4))->expected_mm, 12.0);
  EXPECT_DOUBLE_EQ(durability(leaking_by(0.4))->outlasting, 1.0);
  EXPECT_DOUBLE_EQ(price(durability_terms(*durability(leaking_by(2.0))), {}), 0.25 * 9.5);
}

TEST(Durability, IsUnknownWithoutAllCoursesAndZeroWhereThePlanLeaksAtOnce) {
  PlanRecord record = leaking_by(0.4);
  record.closures.erase(disease_courses()[3].indices[2]);
  EXPECT_FALSE(durability(record));
  PlanRecord leaks = leaking_by(0.4);
  leaks.closures[0] = closure_leaking(6.0);
  EXPECT_EQ(durability(leaks)->expected_mm, 0.0);
}

TEST(Durability, LiesWhereLeaksPassTheLimitWithinTheirNumericalError) {
  const double error_mm2 = area_error_mm2(5.0, {.triangles = 650});
  const Interval within = *durability_interval(leaking_by(2.0), 650);
  EXPECT_DOUBLE_EQ(within.low, 0.5 * (5.0 - error_mm2));
  EXPECT_DOUBLE_EQ(within.high, 0.5 * (5.0 + error_mm2));
  // A course of which nothing is closed behind its leak goes on rising as it did.
  PlanRecord ended = leaking_by(2.0);
  for (const DiseaseCourse& course : disease_courses()) ended.closures.erase(course.indices[2]);
  EXPECT_EQ(*durability_interval(ended, 650), within);
  // As far as courses go.
  EXPECT_EQ(durability_interval(leaking_by(0.1), 650), (Interval{12.0, 12.0}));
  EXPECT_FALSE(durability_interval(PlanRecord{}, 650));
}

TEST(Durability, AClosureThatFailsCountsAsLeaking) {
  PlanRecord record = leaking_by(0.4);
  record.closures[disease_courses()[0].indices[2]] = closure_leaking(std::nan(""));
  EXPECT_DOUBLE_EQ(durability(record)->expected_mm, (7.0 * 12.0 + 4.0) / 8.0);
}

RankedPlan ranked(double leak_mm2, double opens_mm2, double lasts_mm, int steps) {
  RankedPlan plan;
  plan.measure.leak.area_mm2 = leak_mm2;
  plan.region.leak_mm2 = {leak_mm2, leak_mm2, 0.0, leak_mm2, leak_mm2, 1.0, 1.0, 1.0};
  plan.opening = opening(opens_mm2, 3.0);
  plan.durability = Durability{lasts_mm, 0.0};
  plan.effort.steps = steps;
  return plan;
}

std::vector<bool> fronts(std::vector<RankedPlan> plans) {
  mark_pareto(plans);
  std::vector<bool> marked;
  for (const RankedPlan& plan : plans) marked.push_back(plan.pareto);
  return marked;
}

TEST(MarkPareto, GoesByLeakOpeningAndDurabilityAsPrinted) {
  EXPECT_EQ(fronts({ranked(0.10, 300.0, 4.0, 2), ranked(0.14, 301.0, 4.01, 1),
                    ranked(0.1, 350.0, 3.0, 1), ranked(0.3, 300.0, 3.0, 1)}),
            (std::vector{false, true, true, false}));
}

TEST(MarkPareto, ATieGoesToTheSimplerPlanWhateverItMoves) {
  std::vector<RankedPlan> plans = {ranked(0.1, 300.0, 4.0, 1), ranked(0.1, 300.0, 4.0, 1)};
  plans[0].effort.posteromedial_movement_mm = 6.0;
  EXPECT_EQ(fronts(plans), (std::vector{true, true}));
  plans[1].effort.sizes_below = 2.0;
  EXPECT_EQ(fronts(plans), (std::vector{true, false}));
}

TEST(MarkPareto, LeavesOutAnObjectiveThatIsNotKnownOfAllAndStenoticPlans) {
  std::vector<RankedPlan> plans = {ranked(0.1, 300.0, 2.0, 1), ranked(0.2, 300.0, 5.0, 1)};
  EXPECT_EQ(fronts(plans), (std::vector{true, true}));
  plans[1].durability.reset();
  EXPECT_EQ(fronts(plans), (std::vector{true, false}));
  EXPECT_EQ(fronts({ranked(0.0, 140.0, 6.0, 1), ranked(3.0, 300.0, 1.0, 1)}),
            (std::vector{false, true}));
}

}  // namespace
}  // namespace coapt::scene
