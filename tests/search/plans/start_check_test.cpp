#include "search/plans/start_check.h"

#include "tests/search/plans/search_scene.h"

namespace coapt::scene {
namespace {

/// Ends 0.5 mm higher from the open state than from another closure where the posteromedial tip is
/// more than so far from where it is; leaks a tenth of that more.
Evaluator two_ends(double beyond_mm) {
  return [beyond_mm](const Valve& valve, const ClosureResult* from) {
    auto closure = std::make_shared<ClosureResult>();
    closure->status = ClosureStatus::Converged;
    closure->closed_mm = valve.rest_mm;
    const bool elsewhere = from == nullptr && moved_mm(valve, Side::Posteromedial) > beyond_mm;
    if (elsewhere) closure->closed_mm.col(2).array() += 0.5;
    return ClosedPlan{leaking(elsewhere ? 0.05 : 0.0), closure};
  };
}

TEST(StartCheck, CountsTheNodesThatAColdStartLeadsElsewhere) {
  for (const auto& [beyond_mm, elsewhere] : {std::pair{1e9, 0}, {0.0, kStartSample}}) {
    EvaluationScene scene(two_ends(beyond_mm));
    const PlanRecord& plan = scene.closed(suture(Side::Posteromedial, 25.0), 65);
    const int closures = scene.evaluations.closures();
    const std::optional<StartCheck> check = check_starts(scene.evaluations, plan, 65);
    ASSERT_TRUE(check);
    EXPECT_EQ(check->closures, kStartSample);
    EXPECT_EQ(check->elsewhere, elsewhere);
    EXPECT_DOUBLE_EQ(check->leak_difference_max_mm2, elsewhere > 0 ? 0.05 : 0.0);
    EXPECT_EQ(scene.evaluations.closures(), closures) << "nothing counts them";
  }
}

TEST(StartCheck, TakesNoMoreNodesThanThereAreAndNoneWithoutClosures) {
  EvaluationScene scene(two_ends(1e9)), without(needs_suture);
  const RepairPlan plan = suture(Side::Posteromedial, 25.0);
  EXPECT_EQ(check_starts(scene.evaluations, scene.closed(plan, 4), 4)->closures, 3);
  EXPECT_FALSE(check_starts(scene.evaluations, scene.closed(plan, 1), 1));
  EXPECT_FALSE(check_starts(without.evaluations, without.closed(plan, 9), 9));
}

TEST(StartCheck, ASearchSaysItWithTheEvidence) {
  SearchOptions options = small_search();
  options.evaluations = 20;
  options.plans = 1;
  EXPECT_FALSE(searched(two_ends(1e9), options).plans.at(0).starts);
  options.evidence = true;
  EXPECT_EQ(searched(two_ends(1e9), options).plans.at(0).starts->closures,
            options.region_points - 1);
}

TEST(StartCheck, OfRealClosuresIsTheSameForAnyNumberOfThreads) {
  expect_same_on_any_threads([](PlanEvaluations& evaluations) {
    PlanRecord& plan = evaluations.record(own_ring(2));
    std::vector<PlanEvaluations::Wanted> wanted;
    for (int d = 0; d < 33; ++d) wanted.push_back({&plan, d});
    EXPECT_TRUE(evaluations.close(wanted, PlanEvaluations::Phase::Ranking));
    std::vector<double> leaks;
    for (const auto& [d, closure] : plan.closures) leaks.push_back(closure.leak_mm2);
    const StartCheck check = check_starts(evaluations, plan, 33).value();
    EXPECT_EQ(check.closures, kStartSample);
    leaks.push_back(check.leak_difference_max_mm2);
    return leaks;
  });
}

}  // namespace
}  // namespace coapt::scene
