#include "search/plans/branch_search.h"

#include <gtest/gtest.h>

#include <cmath>

namespace coapt {
namespace {

// Two movements of 0 to 10 mm in halves: 21 x 21 points. The cost has one valley, at 2.5 and 8 mm.
Branch two_movements() {
  Branch branch;
  branch.parameters = {{ParameterOf::Movement, 0, 0.0, 0.5, 21, 10},
                       {ParameterOf::Movement, 1, 0.0, 0.5, 21, 10}};
  return branch;
}

double value(const Branch& branch, const LatticePoint& at, std::size_t k) {
  return branch.parameters[k].lower + branch.parameters[k].step * at[k];
}

std::optional<PointCost> valley(const Branch& branch, const LatticePoint& at) {
  const double a = value(branch, at, 0) - 2.5, b = value(branch, at, 1) - 8.0;
  return PointCost{a * a + b * b + 0.5 * a * b, 1};
}

/// A search that knows its start.
struct Scene {
  explicit Scene(const TryPoint& try_point = valley) {
    search.branch = &branch;
    add_point(search, start_of(branch), *try_point(branch, start_of(branch)));
  }
  Branch branch = two_movements();
  BranchSearch search;
};

TEST(BranchSearch, FindsTheBestPointOfTheLattice) {
  Scene scene;
  EXPECT_EQ(scene.search.best, (LatticePoint{10, 10}));
  refine(scene.search, 40, 1, valley);
  EXPECT_EQ(scene.search.best, (LatticePoint{5, 16}));
  EXPECT_EQ(scene.search.best_cost, 0.0);
}

TEST(BranchSearch, FindsItWithEachOfItsOptimisers) {
  for (const int rounds : {0, 1, 2}) {
    Scene scene;
    scene.search.rounds = rounds;
    refine(scene.search, 60, 7, valley);
    EXPECT_EQ(scene.search.best_cost, 0.0) << rounds;
    EXPECT_EQ(scene.search.rounds, rounds + 1);
  }
}

TEST(BranchSearch, FindsABorderWithAKink) {
  // Flat valley floor along a diagonal kink, lowest in a corner.
  const TryPoint kink = [](const Branch& branch, const LatticePoint& at) {
    const double a = value(branch, at, 0), b = value(branch, at, 1);
    return std::optional<PointCost>(PointCost{5.0 * std::abs(a - b) + a, 1});
  };
  Scene scene(kink);
  for (int round = 0; round < 6; ++round) refine(scene.search, 40, 1, kink);
  EXPECT_LE(scene.search.best_cost, 1.0);
}

TEST(BranchSearch, SpendsItsQuotaToTheLastTrialAndNeverTwiceOnOnePoint) {
  int calls = 0;
  const TryPoint once = [&calls](const Branch& branch, const LatticePoint& at) {
    ++calls;
    return valley(branch, at);
  };
  Scene scene;
  for (const int quota : {1, 7, 150}) {
    const int before = calls;
    refine(scene.search, quota, 3, once);
    EXPECT_EQ(calls - before, quota);
  }
  EXPECT_EQ(scene.search.costs.size(), static_cast<std::size_t>(calls) + 1);
}

TEST(BranchSearch, PointsThatCostNothingDoNotUseTheQuotaUp) {
  // Half of the points are known to be no better.
  int closed = 0;
  const TryPoint half = [&closed](const Branch& branch, const LatticePoint& at) {
    const bool free = at[0] % 2 == 1;
    closed += free ? 0 : 1;
    return std::optional<PointCost>(PointCost{valley(branch, at)->cost, free ? 0 : 1});
  };
  Scene scene;
  refine(scene.search, 50, 3, half);
  EXPECT_EQ(closed, 50);
  EXPECT_GT(scene.search.costs.size(), 51u);
  const TryPoint free = [](const Branch& branch, const LatticePoint& at) {
    return std::optional<PointCost>(PointCost{valley(branch, at)->cost, 0});
  };
  refine(scene.search, 5, 3, free);  // ends
}

TEST(BranchSearch, EndsWhenEveryPointIsKnown) {
  Scene scene;
  EXPECT_FALSE(is_exhausted(scene.search));
  refine(scene.search, 100000, 1, valley);
  EXPECT_EQ(scene.search.costs.size(), 21u * 21u);
  EXPECT_TRUE(is_exhausted(scene.search));
  refine(scene.search, 10, 1, [](const Branch&, const LatticePoint&) -> std::optional<PointCost> {
    ADD_FAILURE() << "tried again";
    return std::nullopt;
  });
}

TEST(BranchSearch, ABranchWithoutParametersIsOnePoint) {
  Branch branch;
  BranchSearch search;
  search.branch = &branch;
  EXPECT_EQ(point_count(branch), 1);
  add_point(search, {}, {3.0, 1, false});
  EXPECT_TRUE(is_exhausted(search));
  refine(search, 10, 1, valley);
  EXPECT_EQ(search.best_cost, 3.0);
}

TEST(BranchSearch, EndsWhenStopped) {
  Scene scene;
  int calls = 0;
  const TryPoint limited = [&calls](const Branch& branch,
                                    const LatticePoint& at) -> std::optional<PointCost> {
    if (++calls > 5) return std::nullopt;
    return valley(branch, at);
  };
  refine(scene.search, 100, 1, limited);
  EXPECT_EQ(calls, 6);
  EXPECT_EQ(scene.search.costs.size(), 1u + 5u);
}

TEST(BranchSearch, SurvivesAPlateau) {
  const TryPoint flat = [](const Branch&, const LatticePoint&) {
    return std::optional<PointCost>(PointCost{1.0, 1});
  };
  Scene scene(flat);
  refine(scene.search, 60, 1, flat);
  EXPECT_EQ(scene.search.costs.size(), 61u);
  EXPECT_EQ(scene.search.best, (LatticePoint{10, 10})) << "the first stays";
}

TEST(BranchSearch, IsTheSameForTheSameSeed) {
  Scene a, b, c;
  refine(a.search, 120, 5, valley);
  refine(b.search, 120, 5, valley);
  refine(c.search, 120, 6, valley);
  EXPECT_EQ(a.search.costs, b.search.costs);
  EXPECT_NE(a.search.costs, c.search.costs);
}

}  // namespace
}  // namespace coapt
