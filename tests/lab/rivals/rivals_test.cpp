#include "lab/rivals/rivals.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "tests/lab/rivals/lattices.h"

namespace coapt::rivals {
namespace {

const std::set<std::string> kDeterministic{"direct", "direct_l", "ags"};

class EveryRival : public testing::TestWithParam<std::string> {};

TEST_P(EveryRival, FindsTheBottomOfABowlWithinItsCombinations) {
  const LatticeTable table = bowl();
  for (const std::uint64_t seed : {1, 2, 3}) {
    const RivalRun run = run_rival(table, {GetParam(), seed, 125, {}});
    EXPECT_EQ(run.improvements.back().cost, 0.0);
    EXPECT_LE(run.evaluations, 125);
    EXPECT_LE(run.calls, 20 * 125);
  }
}

TEST_P(EveryRival, SpendsItsBudgetExactlyWhereItDoesNotStall) {
  const LatticeTable table = ring_and_anchors();
  for (const int budget : {0, 1, 2, 7, 100}) {
    const RivalRun run = run_rival(table, {GetParam(), 5, budget, {}});
    EXPECT_EQ(run.evaluations, budget);
    EXPECT_LE(run.calls, 20 * budget);
    for (const Improvement& i : run.improvements) EXPECT_LE(i.evaluations, budget);
  }
}

TEST_P(EveryRival, ReportsCostsOfTheTableThatOnlyFall) {
  const LatticeTable table = ring_and_anchors();
  const RivalRun run = run_rival(table, {GetParam(), 7, 200, {}});
  ASSERT_FALSE(run.improvements.empty());
  for (std::size_t i = 0; i < run.improvements.size(); ++i) {
    EXPECT_GT(std::count(table.costs.begin(), table.costs.end(), run.improvements[i].cost), 0);
    if (i == 0) continue;
    EXPECT_LT(run.improvements[i].cost, run.improvements[i - 1].cost);
    EXPECT_GT(run.improvements[i].evaluations, run.improvements[i - 1].evaluations);
  }
}

TEST_P(EveryRival, RepeatsItsRunWithTheSameSeedWhateverRanBefore) {
  const LatticeTable table = ring_and_anchors();
  const RivalRun first = run_rival(table, {GetParam(), 11, 300, {}});
  for (const std::string& other : rival_names()) run_rival(bowl(), {other, 3, 20, {}});
  EXPECT_EQ(run_rival(table, {GetParam(), 11, 300, {}}), first);
}

TEST_P(EveryRival, RunsElsewhereWithAnotherSeedUnlessItIsDeterministic) {
  const LatticeTable table = ring_and_anchors();
  std::set<std::vector<std::pair<int, double>>> runs;
  for (const std::uint64_t seed : {1, 2, 3, 4}) {
    std::vector<std::pair<int, double>> improvements;
    for (const Improvement& i : run_rival(table, {GetParam(), seed, 300, {}}).improvements)
      improvements.emplace_back(i.evaluations, i.cost);
    runs.insert(improvements);
  }
  EXPECT_EQ(runs.size() == 1, kDeterministic.contains(GetParam()));
}

TEST_P(EveryRival, EndsOnAPlateauAndWhereAlmostAllIsImpossible) {
  LatticeTable plateau = ring_and_anchors();
  std::fill(plateau.costs.begin(), plateau.costs.end(), 1.0);
  EXPECT_EQ(run_rival(plateau, {GetParam(), 1, 200, {}}).improvements,
            (std::vector<Improvement>{{1, 1.0}}));
  LatticeTable impossible = plateau;
  std::fill(impossible.costs.begin() + 1, impossible.costs.end(), HUGE_VAL);
  EXPECT_LE(run_rival(impossible, {GetParam(), 1, 200, {}}).improvements.size(), 1u);
}

INSTANTIATE_TEST_SUITE_P(Rivals, EveryRival, testing::ValuesIn(rival_names()),
                         [](const auto& rival) { return rival.param; });

TEST(RandomRival, MeetsAllCombinationsExactlyOnce) {
  const LatticeTable table = ring_and_anchors();
  const auto all = static_cast<int>(table.costs.size());
  const auto possible = std::count_if(table.costs.begin(), table.costs.end(),
                                      [](double cost) { return std::isfinite(cost); });
  const RivalRun run = run_rival(table, {"random", 1, all, {}});
  EXPECT_EQ(run.evaluations, possible);
  EXPECT_LE(run.calls, all);
}

TEST(RandomRival, MeetsTheBestOfHalfTheCombinationsInHalfOfTheRuns) {
  const LatticeTable table = bowl();
  int met = 0;
  for (std::uint64_t seed = 0; seed < 400; ++seed)
    met += run_rival(table, {"random", seed, 62, {}}).improvements.back().cost == 0.0 ? 1 : 0;
  EXPECT_NEAR(met, 400 * 62 / 125.0, 40.0);  // four standard deviations
}

TEST(SobolRival, NeedsFewCallsMoreThanEvaluations) {
  const RivalRun run = run_rival(ring_and_anchors(), {"sobol", 1, 500, {}});
  EXPECT_EQ(run.evaluations, 500);
  EXPECT_LE(run.calls, 550);
}

TEST(Rivals, OneFromElsewhereIsGivenTheCountsTheSeedAndTheCost) {
  const LatticeTable table = bowl();
  const RivalRun run =
      run_rival(table, {"mine", 9, 2, {}}, [](const RivalProblem& problem, const SharesCost& cost) {
        EXPECT_EQ(problem.counts, (std::vector<int>{5, 5, 5}));
        EXPECT_EQ(problem.seed, 9u);
        EXPECT_EQ(problem.most_calls, 40);
        EXPECT_EQ(cost({0.0, 0.0, 0.0}), 14.0);
        EXPECT_EQ(cost({0.7, 0.3, 0.5}), 0.0);
        EXPECT_EQ(cost({0.9, 0.3, 0.5}), std::nullopt);
      });
  EXPECT_EQ(run, (RivalRun{"mine", 9, {{1, 14.0}, {2, 0.0}}, 2, 2}));
}

}  // namespace
}  // namespace coapt::rivals
