#include "search/refine.h"

#include <gtest/gtest.h>

#include <cmath>

namespace coapt {
namespace {

// Two sutures of 20 to 30 mm; the cost has one valley, at 22.5 and 28 mm.
StrategySearch two_sutures() {
  StrategySearch search;
  search.strategy.plan.steps = {PapillaryApproximation{.side = Side::Anterolateral},
                                PapillaryApproximation{.side = Side::Posteromedial}};
  search.strategy.parameters = {{{0}, 20.0, 30.0, 25.0, 0.5}, {{1}, 20.0, 30.0, 25.0, 0.5}};
  return search;
}

double length(const RepairPlan& plan, std::size_t step) {
  return std::get<PapillaryApproximation>(plan.steps[step]).suture_length_mm;
}

std::optional<Trial> valley(const Strategy& strategy, const std::vector<int>& at) {
  Trial trial;
  trial.plan = plan_at(strategy, at);
  const double a = length(trial.plan, 0) - 22.5, b = length(trial.plan, 1) - 28.0;
  trial.cost = a * a + b * b + 0.5 * a * b;
  return trial;
}

TEST(Refine, FindsTheBestPointOfTheLattice) {
  StrategySearch search = two_sutures();
  try_start(search, valley);
  EXPECT_EQ(length(search.best->plan, 0), 25.0);
  refine(search, 40, 1, valley);
  EXPECT_EQ(search.best->cost, 0.0);
  EXPECT_EQ(length(search.best->plan, 0), 22.5);
  EXPECT_EQ(length(search.best->plan, 1), 28.0);
}

TEST(Refine, SpendsItsQuotaToTheLastTrialAndNeverTwiceOnOnePoint) {
  StrategySearch search = two_sutures();
  int calls = 0;
  const TryPoint counted = [&calls](const Strategy& strategy, const std::vector<int>& at) {
    ++calls;
    return valley(strategy, at);
  };
  try_start(search, counted);
  for (const int quota : {1, 7, 150}) {
    const int before = calls;
    refine(search, quota, 3, counted);
    EXPECT_EQ(calls - before, quota);
  }
  EXPECT_EQ(search.costs.size(), static_cast<std::size_t>(calls));
  EXPECT_EQ(search.history.size(), static_cast<std::size_t>(calls));
}

TEST(Refine, EndsWhenEveryPointIsKnown) {
  StrategySearch search = two_sutures();
  try_start(search, valley);
  refine(search, 10000, 1, valley);
  EXPECT_EQ(search.costs.size(), 21u * 21u);
  EXPECT_TRUE(is_exhausted(search));
}

TEST(Refine, EndsWhenStopped) {
  StrategySearch search = two_sutures();
  int calls = 0;
  const TryPoint limited = [&calls](const Strategy& strategy, const std::vector<int>& at) {
    return ++calls <= 5 ? valley(strategy, at) : std::nullopt;
  };
  try_start(search, limited);
  refine(search, 100, 1, limited);
  EXPECT_EQ(search.costs.size(), 5u);
  EXPECT_TRUE(search.best.has_value());
}

TEST(Refine, SurvivesAPlateau) {
  StrategySearch search = two_sutures();
  const TryPoint flat = [](const Strategy& strategy, const std::vector<int>& at) {
    return std::optional<Trial>(Trial{plan_at(strategy, at), {}, 1.0});
  };
  try_start(search, flat);
  refine(search, 60, 1, flat);
  EXPECT_EQ(search.costs.size(), 61u);
}

TEST(Refine, IsTheSameForTheSameSeed) {
  StrategySearch a = two_sutures(), b = two_sutures(), c = two_sutures();
  for (StrategySearch* search : {&a, &b, &c}) try_start(*search, valley);
  refine(a, 120, 5, valley);
  refine(b, 120, 5, valley);
  refine(c, 120, 6, valley);
  EXPECT_EQ(a.history, b.history);
  EXPECT_NE(a.history, c.history);
}

}  // namespace
}  // namespace coapt
