#include "search/plans/plan_search.h"

#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "core/repair/describe.h"
#include "search/plans/exploration.h"
#include "tests/search/plans/search_scene.h"

namespace coapt::scene {
namespace {

TEST(PlanSearch, GivesTheSameBitsForAnyNumberOfThreads) {
  SearchOptions options = small_search();
  options.evaluations = 700;
  options.threads = 1;
  const SearchResult one = searched(needs_suture, options);
  for (const int threads : {2, 3}) {
    options.threads = threads;
    expect_same(searched(needs_suture, options), one);
  }
}

TEST(PlanSearch, GivesTheSameFirstPlansHoweverFewAreReported) {
  SearchOptions options = small_search();
  options.evaluations = 300;
  options.region_points = 65;
  options.plans = 5;
  const SearchResult five = searched(needs_suture, options);
  ASSERT_EQ(five.plans.size(), 5u);
  for (const int plans : {1, 2, 4}) {
    options.plans = plans;
    const SearchResult fewer = searched(needs_suture, options);
    ASSERT_EQ(std::ssize(fewer.plans), plans);
    EXPECT_EQ(fewer.closures, five.closures);
    for (int i = 0; i < plans; ++i) {
      EXPECT_EQ(plan_key(fewer.plans[i].plan), plan_key(five.plans[i].plan)) << plans;
      EXPECT_EQ(fewer.plans[i].of_class, five.plans[i].of_class) << plans;
      EXPECT_EQ(fewer.plans[i].cost, five.plans[i].cost) << plans;
    }
    EXPECT_FALSE(fewer.plans.back().ties_with_next) << "the last";
  }
}

TEST(PlanSearch, RealClosuresGiveTheSameBitsForAnyNumberOfThreads) {
  SearchOptions options = small_search();
  options.evaluations = 12;
  options.plans = 1;
  options.region_points = 3;
  options.closure.max_steps = 300;
  options.threads = 1;
  const SearchResult one = searched({}, options);
  EXPECT_FALSE(one.plans.empty());
  for (const int threads : {2, 3}) {
    options.threads = threads;
    expect_same(searched({}, options), one);
  }
}

TEST(PlanSearch, FindsTheSutureThatTheValveNeeds) {
  SearchOptions options = small_search();
  options.evaluations = 600;
  options.region_points = 65;
  const SearchResult result = searched(needs_suture, options);
  EXPECT_NEAR(result.before.measure.leak.area_mm2, 2.0 * (kTipToTrigone_mm - 24.0), 1e-3);
  const RankedPlan& best = result.plans.at(0);
  EXPECT_GT(best.effort.posteromedial_movement_mm, 2.0);
  EXPECT_EQ(best.effort.anterolateral_movement_mm, 0.0);
  EXPECT_EQ(best.effort.steps, 1);
  EXPECT_LE(best.region.leak_mm2.nominal, 0.5);
  // The region stretches the suture by up to 1 mm: a plan that just closes leaks there.
  EXPECT_LT(best.region.leak_mm2.mean + best.region.leak_mm2.sd, kTraceLeak_mm2);
  EXPECT_TRUE(result.any_acceptable);
  EXPECT_TRUE(is_acceptable(result));
}

TEST(PlanSearch, RanksByTheRegionAndGivesDistinctAlternatives) {
  const SearchResult result = searched(needs_suture, small_search());
  ASSERT_EQ(result.plans.size(), 3u);
  std::set<std::vector<std::string>> distinct;
  for (std::size_t i = 0; i < 3; ++i) {
    const RankedPlan& plan = result.plans[i];
    EXPECT_EQ(plan.rank, static_cast<int>(i) + 1);
    EXPECT_EQ(plan.region.closures, 9);
    EXPECT_EQ(plan.subset_nodes, 9);
    EXPECT_GE(plan.region.leak_mm2.worst, plan.region.leak_mm2.mean);
    distinct.insert(plan.description);
    if (i == 0) continue;
    EXPECT_GE(plan.cost, result.plans[i - 1].cost);
  }
  EXPECT_EQ(distinct.size(), 3u);
}

TEST(PlanSearch, ProgressFallsAndNeverRises) {
  SearchOptions options = small_search();
  options.evaluations = 400;
  const SearchResult result = searched(needs_suture, options);
  ASSERT_FALSE(result.progress.empty());
  ASSERT_FALSE(result.random_progress.empty());
  for (std::size_t i = 1; i < result.progress.size(); ++i) {
    const bool is_last = i + 1 == result.progress.size();  // tells how long it went on
    EXPECT_LT(result.progress[i].cost, result.progress[i - 1].cost + (is_last ? 1e-12 : 0.0));
    EXPECT_GE(result.progress[i].closures, result.progress[i - 1].closures);
  }
  for (std::size_t i = 1; i < result.random_progress.size(); ++i)
    EXPECT_LE(result.random_progress[i].cost, result.random_progress[i - 1].cost + 1e-12);
}

TEST(PlanSearch, TheLeadingPlanHasMoreNodesOrCostsLessThanTheOneBefore) {
  std::vector<std::shared_ptr<const LeadingPlan>> leading;
  SearchContext context;
  context.evaluate = needs_suture;
  context.progress = [&leading](const SearchProgress& now) {
    if (now.leading && (leading.empty() || leading.back() != now.leading))
      leading.push_back(now.leading);
  };
  const SearchResult result = *search_plans(small_valve(), small_search(), context);
  ASSERT_FALSE(leading.empty());
  for (std::size_t i = 1; i < leading.size(); ++i) {
    const LeadingPlan &now = *leading[i], &before = *leading[i - 1];
    EXPECT_TRUE(now.nodes > before.nodes || (now.nodes == before.nodes && now.cost < before.cost));
    EXPECT_EQ(now.description, describe(small_valve(), now.plan));
  }
}

TEST(PlanSearch, EveryPlanTriedIsListedOnceWithItsRank) {
  const SearchResult result = searched(needs_suture, small_search());
  EXPECT_EQ(std::ssize(result.tried), result.plans_tried);
  std::set<std::string> keys;
  std::map<int, std::string> ranked;
  for (const TriedPlan& tried : result.tried) {
    EXPECT_TRUE(keys.insert(plan_key(tried.plan)).second);
    EXPECT_GE(tried.nodes, 1);
    if (tried.nodes == 1) {
      EXPECT_EQ(tried.cost, tried.cost_as_planned);
    }
    if (tried.rank > 0) ranked[tried.rank] = plan_key(tried.plan);
  }
  ASSERT_EQ(ranked.size(), result.plans.size());
  for (const RankedPlan& plan : result.plans) EXPECT_EQ(ranked[plan.rank], plan_key(plan.plan));
}

TEST(PlanSearch, CountsFailedClosuresAndTrustsNone) {
  // Every valve whose muscle was moved seems perfect, but its leaflets cross.
  const Evaluator evaluate = [](const Valve& valve, const ClosureResult* from) {
    ClosedPlan closed = needs_suture(valve, from);
    if (moved_mm(valve, Side::Posteromedial) > 1.9) {
      closed.evaluation.measure.leak.area_mm2 = 0.0;
      closed.evaluation.crossing = true;
    }
    return closed;
  };
  const SearchResult result = searched(evaluate, small_search());
  EXPECT_GT(result.closures_crossed, 0);
  EXPECT_EQ(result.closures_not_converged, 0);
  ASSERT_FALSE(result.plans.empty());
  EXPECT_FALSE(result.plans[0].crossing);
}

TEST(PlanSearch, ALeakThatIsNoNumberIsRankedBehindEveryNumber) {
  // A ring leaves no number at all; a suture leaves 40 mm2.
  const Evaluator evaluate = leak_of([](const Valve& valve) {
    return has_ring(valve) ? std::numeric_limits<double>::quiet_NaN() : 40.0;
  });
  SearchOptions options = small_search();
  options.evaluations = 200;
  options.plans = 20;
  const SearchResult result = searched(evaluate, options);
  bool failed = false;
  for (const RankedPlan& plan : result.plans) {
    EXPECT_FALSE(std::isnan(plan.cost));
    const bool fails = std::isnan(plan.region.leak_mm2.nominal);
    EXPECT_TRUE(fails || !failed) << plan.rank;
    failed = failed || fails;
  }
  ASSERT_FALSE(result.plans.empty());
  EXPECT_EQ(result.plans[0].region.leak_mm2.nominal, 40.0);
  EXPECT_FALSE(result.any_acceptable);
}

TEST(PlanSearch, AValveThatNeverConvergesStillGetsItsLeastOperation) {
  const Evaluator evaluate = [](const Valve&, const ClosureResult*) {
    Evaluation evaluation = leaking(std::numeric_limits<double>::quiet_NaN());
    evaluation.status = ClosureStatus::Diverged;
    evaluation.measure.tension_max_n = std::numeric_limits<double>::quiet_NaN();
    return ClosedPlan{evaluation, nullptr};
  };
  const SearchResult result = searched(evaluate, small_search());
  EXPECT_EQ(result.closures_not_converged, result.closures);
  EXPECT_FALSE(result.any_acceptable);
  EXPECT_TRUE(result.pareto_front.empty());
  ASSERT_EQ(result.plans.size(), 3u);
  EXPECT_FALSE(result.plans[0].warnings.empty());
  EXPECT_EQ(result.plans[0].effort.steps, 1);
  for (std::size_t i = 1; i < 3; ++i) EXPECT_GE(result.plans[i].cost, result.plans[i - 1].cost);
}

TEST(PlanSearch, AValveThatAlwaysLeaksGetsTheLeastBadPlan) {
  const Evaluator evaluate = leak_of([](const Valve& valve) {
    return 20.0 - std::min(8.0, moved_mm(valve, Side::Anterolateral));
  });
  SearchOptions options = small_search();
  options.evaluations = 600;
  const SearchResult result = searched(evaluate, options);
  EXPECT_FALSE(result.any_acceptable);
  EXPECT_FALSE(is_acceptable(result));
  // A millimetre costs 0.2 and saves 6.
  EXPECT_GT(result.plans.at(0).effort.anterolateral_movement_mm, 7.0);
}

TEST(PlanSearch, FixedStepsAreInEveryPlanAndForbiddenOnesInNone) {
  SearchOptions options = small_search();
  options.evaluations = 300;
  options.threads = 1;
  options.rules.fixed = own_ring(1);
  options.rules.forbidden = {"papillary_approximation:saddle_peak",
                             "papillary_approximation:anterolateral"};
  SearchContext context = context_of(needs_suture);
  std::set<std::string> closed;
  context.keep = [&closed](const std::string& key, int, const PlanClosure&) { closed.insert(key); };
  const SearchResult result = searched(options, context);
  EXPECT_GT(closed.size(), 20u);
  for (const std::string& key : closed) {
    EXPECT_NE(key.find("ring \"own\" 0.000000 1"), std::string::npos) << key;
    EXPECT_EQ(key.find("saddle_peak"), std::string::npos) << key;
    EXPECT_EQ(key.find("anterolateral"), std::string::npos) << key;
  }
  // The ring alone, to the trigone, to a free point.
  EXPECT_EQ(result.branches, 3);
  EXPECT_EQ(result.plans_possible, 1 + 15 + 15 * 9);
}

TEST(PlanSearch, RulesThatCloseAllThatIsIndicatedLeaveNoPlanAndTheReason) {
  SearchOptions options = small_search();
  options.rules.forbidden = {"annuloplasty", "papillary_approximation"};
  const SearchResult result = searched(options, context_of(needs_suture));
  EXPECT_TRUE(result.plans.empty());
  EXPECT_FALSE(result.any_acceptable);
  EXPECT_EQ(result.stop, SearchStop::Exhausted);
  EXPECT_TRUE(std::any_of(result.cut.begin(), result.cut.end(), [](const CutBranches& cut) {
    return cut.what == "suture of the posteromedial muscle" && cut.why == "forbidden";
  }));
}

TEST(PlanSearch, FindsWhatTryingEveryPlanFinds) {
  // One branch, 7 movements x 9 places; the tip is best somewhere off the first guess.
  SearchOptions options = small_search();
  options.evaluations = 100000;
  options.plans = 1;
  options.rank_by_price = true;
  options.region_points = 17;
  options.rules.most_movement_mm = 6.0;
  options.rules.forbidden = {"annuloplasty", "papillary_approximation:anterolateral",
                             "papillary_approximation:ipsilateral_trigone",
                             "papillary_approximation:saddle_peak"};
  for (const Vec3& aim : {Vec3(11.0, 0.5, -21.5), Vec3(14.0, -1.0, -23.0), Vec3(9.0, 1.0, -24.0)}) {
    const Evaluator evaluate = leak_of([aim](const Valve& valve) {
      return (papillary_tip_mm(valve, Side::Posteromedial) - aim).squaredNorm();
    });
    const PlanSpace space(small_valve(), options.rules);
    ASSERT_EQ(space.branches().size(), 1u);
    ASSERT_EQ(point_count(space.branches()[0]), 7 * 9);
    EvaluationScene scene(evaluate);
    const Branch& branch = space.branches()[0];
    double least = std::numeric_limits<double>::infinity();
    for (int number = 0; number < 7 * 9; ++number) {
      PlanRecord& record = scene.evaluations.record(space.plan(branch, point_at(branch, number)));
      EXPECT_TRUE(scene.evaluations.close_here(record, kChosenBy));
      if (record.rejected_by.empty())
        least = std::min(least, scene.evaluations.cost(record, kChosenBy));
    }
    const SearchResult result = searched(evaluate, options);
    EXPECT_EQ(result.stop, SearchStop::Exhausted);
    EXPECT_DOUBLE_EQ(result.plans.at(0).cost, least);
    EXPECT_LT(result.closures, scene.evaluations.closures() / 2);
  }
}

}  // namespace
}  // namespace coapt::scene
