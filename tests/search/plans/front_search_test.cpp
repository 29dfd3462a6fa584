#include "search/plans/front_search.h"

#include <set>

#include "search/plans/plan_space.h"
#include "tests/search/plans/search_scene.h"

namespace coapt::scene {
namespace {

/// Small rings and tight sutures close the valve, small rings open little.
Evaluator narrow_closes() {
  return leak_of([](const Valve& valve) {
    const double far =
        6.0 - moved_mm(valve, Side::Posteromedial) - ring_sizes_below(fitting_valve(), valve);
    return std::max(0.0, 2.0 * far);
  });
}

PlanEvaluationOptions opening_less_by_ring(int threads) {
  PlanEvaluationOptions options = on_threads(threads);
  options.open = [](const Valve& valve) {
    PlanOpening opening;
    opening.measure.opening_area_mm2 = opening.measure.projected_area_mm2 =
        400.0 - 40.0 * ring_sizes_below(fitting_valve(), valve);
    return opening;
  };
  return options;
}

/// All plans of rings and posteromedial sutures, each once.
std::vector<PlanRecord*> candidates(PlanEvaluations& evaluations) {
  SearchRules rules;
  rules.forbidden = {"papillary_approximation:anterolateral",
                     "papillary_approximation:annulus_point"};
  const PlanSpace space(fitting_valve(), rules);
  std::set<PlanRecord*> seen;
  std::vector<PlanRecord*> plans;
  for (const Branch& branch : space.branches())
    for (std::int64_t i = 0; i < point_count(branch); ++i) {
      PlanRecord& plan = evaluations.record(space.plan(branch, point_at(branch, i)));
      if (!is_infeasible(plan) && seen.insert(&plan).second) plans.push_back(&plan);
    }
  return plans;
}

struct Found {
  std::vector<std::string> keys;
  double volume = 0.0;
  int closures = 0;
};

Found found(int closures, std::uint64_t seed, int threads) {
  EvaluationScene scene(narrow_closes(), opening_less_by_ring(threads));
  Found all;
  std::vector<TradeOff> front;
  for (const FrontPlan& one :
       search_front(scene.evaluations, candidates(scene.evaluations), {closures, seed})) {
    all.keys.push_back(one.plan->key);
    if (const auto traded = trade_off(*one.plan, kChosenBy)) front.push_back(*traded);
    EXPECT_LE(one.closures, scene.evaluations.closures() - 1);
  }
  all.volume = dominated_volume(front);
  all.closures = scene.evaluations.closures() - 1;
  return all;
}

TEST(SearchFront, FindsNearlyAllWithFewOfTheClosures) {
  EvaluationScene scene(narrow_closes(), opening_less_by_ring(1));
  const std::vector<PlanRecord*> all = candidates(scene.evaluations);
  ASSERT_GT(all.size(), 300u);
  ASSERT_TRUE(
      measure_trade_offs(scene.evaluations, all, kChosenBy, PlanEvaluations::Phase::Ranking));
  std::vector<TradeOff> every;
  for (const PlanRecord* plan : all)
    if (const auto one = trade_off(*plan, kChosenBy)) every.push_back(*one);
  for (const std::uint64_t seed : {1, 2, 3}) {
    const Found few = found(2000, seed, 1);
    EXPECT_GT(few.volume, 0.98 * dominated_volume(every)) << seed;
    EXPECT_LT(few.closures, scene.evaluations.closures() / 4);
    EXPECT_LT(few.closures, 1500) << "it ends where no plan is expected to add anything";
  }
}

TEST(SearchFront, IsTheSameForAnyNumberOfThreadsAndEndsAtItsBudget) {
  const Found one = found(300, 5, 1), two = found(300, 5, 2);
  EXPECT_EQ(one.keys, two.keys);
  EXPECT_EQ(one.closures, two.closures);
  EXPECT_LE(one.closures, 300);
  EXPECT_EQ(std::set(one.keys.begin(), one.keys.end()).size(), one.keys.size()) << "each once";
}

TEST(SearchFront, OfNoCandidatesIsEmpty) {
  EvaluationScene scene(narrow_closes(), opening_less_by_ring(1));
  EXPECT_TRUE(search_front(scene.evaluations, {}, {}).empty());
}

}  // namespace
}  // namespace coapt::scene
