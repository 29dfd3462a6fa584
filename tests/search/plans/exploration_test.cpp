#include "search/plans/exploration.h"

#include <cmath>
#include <set>

#include "tests/search/plans/search_scene.h"

namespace coapt::scene {
namespace {

struct ExplorationScene {
  ExplorationScene(const Evaluator& evaluate, SearchOptions search)
      : options(std::move(search)),
        space(small_valve(), options.rules),
        plans(evaluate, on_threads(1)),
        exploration(explore({plans.evaluations, space, options, plans.monitor})) {}
  SearchOptions options;
  PlanSpace space;
  EvaluationScene plans;
  ExplorationState exploration;
};

SearchOptions options_of(int evaluations) {
  SearchOptions options = small_search();
  options.evaluations = evaluations;
  return options;
}

/// To the trigone, of one muscle or both: 17, 17 and 289 plans.
SearchOptions trigones_only(int evaluations) {
  SearchOptions options = options_of(evaluations);
  options.rules.forbidden = {"annuloplasty", "papillary_approximation:saddle_peak",
                             "papillary_approximation:annulus_point"};
  return options;
}

TEST(Exploration, TheBestOfEachBranchComesBeforeTheSecondOfAny) {
  ExplorationScene scene(needs_suture, trigones_only(150));
  ASSERT_EQ(scene.space.branches().size(), 3u);
  const auto kind = [](const PlanRecord* plan) {
    return std::pair(plan->effort.anterolateral_movement_mm > 0.0,
                     plan->effort.posteromedial_movement_mm > 0.0);
  };
  const std::vector<PlanRecord*> best = best_plans(scene.exploration, 6);
  ASSERT_EQ(best.size(), 6u);
  EXPECT_EQ((std::set{kind(best[0]), kind(best[1]), kind(best[2])}.size()), 3u);
  EXPECT_EQ((std::set<PlanRecord*>(best.begin(), best.end()).size()), 6u);
  EXPECT_LE(std::ssize(best_plans(scene.exploration, 100000)),
            std::ssize(scene.exploration.trials));
}

TEST(Exploration, ScoredPlansAreThoseClosedAtSeventeenNodes) {
  ExplorationScene scene(needs_suture, trigones_only(300));
  const auto scored = scored_plans(scene.exploration);
  ASSERT_FALSE(scored.empty());
  double least = 1e9;
  for (const PlanRecord* plan : scored) {
    EXPECT_EQ(plan->closures.size(), 17u);
    least = std::min(least, scene.plans.evaluations.guide(*plan, kChosenBy));
  }
  ASSERT_FALSE(scene.exploration.scored_progress.empty());
  EXPECT_EQ(scene.exploration.scored_progress.back().cost, least);
}

TEST(Exploration, PlansWhoseOperationAloneIsTooDearAreNotClosed) {
  // The least movement of the posteromedial muscle already closes the valve: nothing dearer is looked at for long.
  const auto leak = [](const Valve& valve) {
    return moved_mm(valve, Side::Posteromedial) > 0.0 ? 0.0 : 30.0;
  };
  SearchOptions options = trigones_only(100000);
  options.plans = 1;
  ExplorationScene scene(leak_of(leak), options);
  EXPECT_EQ(scene.exploration.stop, SearchStop::Exhausted);
  const PlanRecord* best = best_plans(scene.exploration, 1).at(0);
  EXPECT_EQ(best->effort.anterolateral_movement_mm, 0.0);
  EXPECT_LT(best->effort.posteromedial_movement_mm, 3.5);
  EXPECT_LT(std::ssize(scene.exploration.trials), 100 + 60) << "a hundred at random, and of 323";
}

TEST(Exploration, RandomSearchIsExpectedToReachTheMeanFirstAndTheLeastLast) {
  ExplorationScene scene(needs_suture, options_of(600));
  const std::vector<Progress> random = random_progress(scene.exploration);
  ASSERT_GE(random.size(), 10u);
  for (std::size_t i = 0; i < random.size(); ++i) {
    EXPECT_EQ(random[i].closures, static_cast<int>(i) + 1);
    if (i == 0) continue;
    EXPECT_LE(random[i].cost, random[i - 1].cost + 1e-12);
  }
  EXPECT_GE(random.back().cost, scene.exploration.progress.back().cost - 1e-12);
}

TEST(Exploration, TheLadderIsMeasuredOnceThereAreClosuresForIt) {
  ExplorationScene few(needs_suture, options_of(60)), many(needs_suture, options_of(8000));
  ASSERT_EQ(ladder_of(few.exploration).size(), 3u);
  EXPECT_EQ(ladder_of(few.exploration)[1].plans, 0);
  EXPECT_TRUE(std::isnan(ladder_of(few.exploration)[1].spearman));
  const std::vector<LadderStep> ladder = ladder_of(many.exploration);
  ASSERT_EQ(ladder.size(), 3u);
  for (std::size_t r = 0; r < 3; ++r) {
    EXPECT_EQ(ladder[r].from, r == 0 ? 0 : kRungs[r - 1]);
    EXPECT_EQ(ladder[r].to, kRungs[r]);
    EXPECT_LE(std::abs(ladder[r].spearman), 1.0 + 1e-12);
    if (r == 0) continue;
    EXPECT_EQ(ladder[r].plans, 12);
  }
}

}  // namespace
}  // namespace coapt::scene
