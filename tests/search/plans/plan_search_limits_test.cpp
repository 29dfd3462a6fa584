#include <algorithm>
#include <chrono>
#include <cmath>

#include "search/plans/plan_search.h"
#include "search/plans/ranking.h"
#include "tests/search/plans/search_scene.h"

namespace coapt::scene {
namespace {

TEST(SearchLimits, TheBudgetIsNeverExceeded) {
  for (const int evaluations : {1, 2, 10, 90, 400}) {
    SearchOptions options = small_search();
    options.evaluations = evaluations;
    const SearchResult result = searched(needs_suture, options);
    EXPECT_LE(result.evaluations, evaluations);
    EXPECT_GE(result.evaluations, std::min(evaluations, 2) / 2);
    EXPECT_FALSE(result.plans.empty());
    EXPECT_LE(std::ssize(result.plans), options.plans);
    EXPECT_LE(result.closures, 1 + result.evaluations + 9 * 3 * options.plans);
  }
}

TEST(SearchLimits, ClosuresStayWithinWhatTheHelpOfTheCommandAddsUp) {
  struct Size {
    int evaluations, plans, region_points;
    bool evidence;
  };
  for (const auto& [evaluations, plans, points, evidence] :
       {Size{1, 1, 1, false}, Size{3, 2, 20, false}, Size{40, 2, 66, false},
        Size{12, 1, 2, true}}) {
    SearchOptions options = small_search();
    options.evaluations = evaluations;
    options.plans = plans;
    options.region_points = points;
    options.evidence = evidence;
    const SearchResult result = searched(needs_suture, options);
    EXPECT_LE(result.evaluations, evaluations);
    const int finalists = evidence ? 12 + 8 + 8 : 12;
    EXPECT_LE(result.closures, 1 + evaluations + finalists * std::min(65, points) +
                                   std::max(0, points - 65) +
                                   (evidence ? 24 * finalists + 284 * plans : 0));
    EXPECT_GE(result.closures, 1 + result.evaluations);
    EXPECT_EQ(result.closures_known, 0);
    for (const RankedPlan& plan : result.plans)
      EXPECT_GE(plan.region.closures, plan.rank == 1 ? points : std::min(points, kBeforeTheRegion));
  }
}

TEST(SearchLimits, ASearchThatHasPlansLeftEndsAtItsBudget) {
  // Nothing helps: no operation is dearer than what it must beat, tens of thousands of plans are left.
  const Evaluator evaluate = leak_of([](const Valve&) { return 30.0; });
  for (const int evaluations : {1, 2, 3, 7, 17, 37, 90, 91, 92, 93, 200}) {
    SearchOptions options = small_search();
    options.evaluations = evaluations;
    options.region_points = 1;
    const SearchResult result = searched(evaluate, options);
    EXPECT_EQ(result.stop, SearchStop::EvaluationLimit) << evaluations;
    EXPECT_LE(result.evaluations, evaluations);
  }
}

TEST(SearchLimits, CancelledItReturnsTheBestSoFar) {
  std::atomic<bool> cancelled = false;
  std::atomic<int> calls = 0;
  SearchOptions options = small_search();
  options.threads = 1;
  SearchContext context = context_of(cancelling(needs_suture, calls, 40, cancelled));
  context.cancelled = &cancelled;
  const SearchResult result = searched(options, context);
  EXPECT_EQ(result.stop, SearchStop::Cancelled);
  EXPECT_EQ(calls, 40) << "nothing is closed any more";
  EXPECT_LE(result.closures, 40);
  ASSERT_FALSE(result.plans.empty());
  for (const RankedPlan& plan : result.plans) EXPECT_GE(plan.region.closures, 1);
}

TEST(SearchLimits, CancelledBeforeItBeganItReturnsTheValveAsItIs) {
  const std::atomic<bool> cancelled = true;
  SearchContext context = context_of(needs_suture);
  context.cancelled = &cancelled;
  const SearchResult result = searched(small_search(), context);
  EXPECT_EQ(result.stop, SearchStop::Cancelled);
  EXPECT_EQ(result.closures, 1);
  EXPECT_TRUE(result.plans.empty());
}

TEST(SearchLimits, StoppedWhileRankingItKeepsThePlansWithMostNodesAndComparesOverTheSame) {
  const SearchResult whole = searched(needs_suture, small_search());
  for (const int more : {8, 20}) {
    std::atomic<bool> cancelled = false;
    SearchOptions options = small_search();
    options.threads = 1;
    SearchContext context = context_of(needs_suture);
    context.cancelled = &cancelled;
    int closures = 1;
    context.keep = [&](const std::string&, int, const PlanClosure&) {
      if (++closures == 1 + whole.evaluations + more) cancelled = true;
    };
    const SearchResult result = searched(options, context);
    EXPECT_EQ(result.stop, SearchStop::Cancelled);
    EXPECT_EQ(result.closures, 1 + whole.evaluations + more);
    ASSERT_FALSE(result.plans.empty());
    EXPECT_LE(result.plans.size(), 3u);
    for (const RankedPlan& plan : result.plans) {
      EXPECT_GT(plan.region.closures, 1) << "the search had closed some plans at more";
      EXPECT_EQ(plan.region.closures, result.plans[0].region.closures);
    }
  }
}

TEST(SearchLimits, WithLittleTimeItStillClosesTheRegionOfItsPlans) {
  std::atomic<int> closures = 0;
  SearchContext context = context_of(counted(needs_suture, closures));
  context.now = [&closures] {
    return SearchMonitor::Clock::time_point(std::chrono::milliseconds(closures));
  };
  SearchOptions options = small_search();
  options.evaluations = 100000;
  options.seconds = 0.3;  // of 100, for each closure takes 1 ms
  const SearchResult result = searched(options, context);
  EXPECT_EQ(result.stop, SearchStop::TimeLimit);
  ASSERT_EQ(result.plans.size(), 3u);
  for (const RankedPlan& plan : result.plans) EXPECT_GT(plan.region.closures, 1);
}

TEST(SearchLimits, OutOfTimeItReturnsWhatThereIs) {
  SearchOptions options = small_search();
  options.seconds = 1e-9;
  const SearchResult result = searched(needs_suture, options);
  EXPECT_EQ(result.stop, SearchStop::TimeLimit);
  EXPECT_EQ(result.closures, 1);
  EXPECT_TRUE(result.plans.empty());
}

TEST(SearchLimits, StopsAtTheTarget) {
  SearchOptions options = small_search();
  options.evaluations = 5000;
  options.target_mm2 = 1.0;
  options.region_points = 17;
  const SearchResult result = searched(needs_suture, options);
  EXPECT_EQ(result.stop, SearchStop::TargetReached);
  bool reached = false;
  for (const ParetoPlan& plan : result.pareto_front)
    reached = reached || plan.mean_mm2 + plan.sd_mm2 <= options.target_mm2;
  EXPECT_TRUE(reached);
}

TEST(SearchLimits, StopsWithoutImprovement) {
  SearchOptions options = small_search();
  options.evaluations = 5000;
  options.no_improvement = 40;
  const SearchResult result = searched(leak_of([](const Valve&) { return 30.0; }), options);
  EXPECT_EQ(result.stop, SearchStop::NoImprovement);
  EXPECT_LT(result.evaluations, 1000);
  EXPECT_EQ(result.plans.size(), 3u);
}

TEST(SearchLimits, WithoutARegionItSaysNothingOfIt) {
  SearchOptions options = small_search();
  options.region_points = 1;
  // Every plan leaks 8 mm2: more than is good, at any node.
  const Evaluator evaluate = leak_of([](const Valve&) { return 8.0; });
  const SearchResult result = searched(evaluate, options);
  ASSERT_EQ(result.plans.size(), 3u);
  for (const RankedPlan& plan : result.plans) {
    EXPECT_EQ(plan.region.leak_mm2.nominal, 8.0);
    EXPECT_EQ(plan.region.closures, 1);
    EXPECT_TRUE(std::isnan(plan.region.leak_mm2.mean) && std::isnan(plan.region.leak_mm2.worst));
    EXPECT_TRUE(std::isnan(plan.probability_outranks_next));
    for (const std::string& warning : plan.warnings)
      EXPECT_EQ(warning.find("region"), std::string::npos) << warning;
  }
}

TEST(SearchLimits, ProgressCountsEveryClosureAndNeverExceedsWhatWasPlanned) {
  for (const int evaluations : {60, 400}) {
    SearchOptions options = small_search();
    options.evaluations = evaluations;
    options.evidence = true;
    options.region_points = 70;
    SearchContext context = context_of(needs_suture);
    std::vector<int> seen;
    bool beyond = false;
    double best = 1e9;
    context.progress = [&](const SearchProgress& progress) {
      seen.push_back(progress.closures);
      beyond = beyond || (progress.closures > progress.closures_planned);
      EXPECT_LE(progress.best_leak_mm2, std::max(best, progress.best_leak_mm2));
      best = progress.best_leak_mm2;
    };
    const SearchResult result = searched(options, context);
    ASSERT_EQ(std::ssize(seen), result.closures);
    for (std::size_t i = 0; i < seen.size(); ++i) EXPECT_EQ(seen[i], static_cast<int>(i) + 1);
    EXPECT_FALSE(beyond);
    EXPECT_EQ(best, 0.0);
  }
}

TEST(SearchLimits, ListsEveryOptionOutsideItsRange) {
  const double nan = std::nan("");
  SearchOptions options;
  options.evaluations = 0;
  options.threads = -1;
  options.plans = 51;
  options.region_points = 1090;
  options.seconds = nan;
  options.no_improvement = -1;
  options.target_mm2 = nan;
  options.weights = {nan, nan, nan, nan,  nan, nan, nan,  nan,
                     nan, nan, nan, -1.0, 1e7, nan, -1.0, nan};
  options.rules.forbidden = {"annuloplasty", "surgery"};
  options.rules.most_neochordae = 5;
  options.rules.suture_lattice_mm = nan;
  options.rules.neochorda_lattice_mm = nan;
  options.rules.most_movement_mm = nan;
  const std::vector<std::string> expected = {"/evaluations",
                                             "/threads",
                                             "/plans",
                                             "/region_points",
                                             "/seconds",
                                             "/no_improvement",
                                             "/target_mm2",
                                             "/weights/leak",
                                             "/weights/sd_share",
                                             "/weights/incompetence",
                                             "/weights/margin",
                                             "/weights/coaptation",
                                             "/weights/gap",
                                             "/weights/movement",
                                             "/weights/movement_above_10",
                                             "/weights/undersizing",
                                             "/weights/undersizing_above_4",
                                             "/weights/step",
                                             "/weights/tension",
                                             "/weights/gradient_above_3",
                                             "/weights/gradient_above_5",
                                             "/weights/durability",
                                             "/weights/untrusted",
                                             "/rules/most_neochordae",
                                             "/rules/suture_lattice_mm",
                                             "/rules/neochorda_lattice_mm",
                                             "/rules/most_movement_mm",
                                             "/rules/forbidden/1"};
  EXPECT_EQ(paths_of(search_plans(small_valve(), options, context_of(needs_suture))), expected);
}

TEST(SearchLimits, EverythingForbiddenLeavesNoPlanAndSaysWhy) {
  SearchOptions options = small_search();
  options.rules.forbidden = {"annuloplasty", "papillary_approximation"};
  const auto none = search_plans(small_valve(), options, context_of(needs_suture));
  ASSERT_TRUE(none);
  EXPECT_TRUE(none->plans.empty());
  EXPECT_EQ(none->stop, SearchStop::Exhausted);
  const auto forbidden = std::count_if(none->cut.begin(), none->cut.end(),
                                       [](const auto& cut) { return cut.why == "forbidden"; });
  EXPECT_GE(forbidden, 2) << "rings, and the muscles";
}

TEST(SearchLimits, FixedStepsThatAreForbiddenOrImpossibleAreErrors) {
  SearchOptions options = small_search();
  options.rules.forbidden = {"annuloplasty", "papillary_approximation"};
  options.rules.fixed = suture(Side::Posteromedial, 24.0);
  EXPECT_EQ(paths_of(search_plans(small_valve(), options, context_of(needs_suture))),
            (std::vector<std::string>{"/rules/fixed/steps/0"}))
      << "fixed and forbidden";
  options.rules.forbidden = {};
  options.rules.fixed = suture(Side::Posteromedial, 99.0);
  EXPECT_EQ(paths_of(search_plans(small_valve(), options, context_of(needs_suture))),
            (std::vector<std::string>{"/rules/fixed/steps/0/suture_length_mm"}));
}

}  // namespace
}  // namespace coapt::scene
