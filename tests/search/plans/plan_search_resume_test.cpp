// What was closed before is not closed again, and changes nothing.
#include <stdexcept>

#include "search/plans/plan_search.h"
#include "search/plans/ranking.h"
#include "tests/search/plans/search_scene.h"

namespace coapt::scene {
namespace {

SearchOptions long_search() {
  SearchOptions options = small_search();
  options.evaluations = 100;
  options.threads = 2;
  options.plans = 1;
  options.region_points = 20;
  options.evidence = true;
  return options;
}

/// Throws from closure `most` + 1 on, as a full disk would.
struct Keeper {
  KnownPlans kept{};
  int most = 1 << 30;
  int count = 0;

  auto function() {
    return [this](const std::string& key, int disturbance, const PlanClosure& closure) {
      if (++count > most) throw std::runtime_error("disk full");
      EXPECT_TRUE(kept[key].emplace(disturbance, closure).second) << "kept twice";
    };
  }
};

TEST(ResumedSearch, IsTheSameAndClosesNothingThatIsKnown) {
  Keeper first, second;
  SearchContext context = context_of(needs_suture);
  context.keep = first.function();
  const SearchResult fresh = searched(long_search(), context);
  EXPECT_EQ(fresh.closures_known, 0);
  EXPECT_EQ(first.count, fresh.closures - 1);

  std::atomic<int> calls = 0;
  context = context_of(counted(needs_suture, calls));
  context.known = first.kept;
  context.keep = second.function();
  const SearchResult resumed = searched(long_search(), context);
  expect_same(resumed, fresh);
  EXPECT_EQ(second.count, 0);
  EXPECT_EQ(resumed.closures_known, fresh.closures - 1);
  // The valve as it is, and the finalists for what rules say of their closures.
  EXPECT_GE(calls, 1 + std::ssize(fresh.plans));
  EXPECT_LE(calls, 1 + kFinalists + kFrontFinalists + kReserve);
}

TEST(ResumedSearch, WithMoreEvaluationsClosesOnlyTheNewOnes) {
  Keeper keeper;
  SearchContext context = context_of(needs_suture);
  context.keep = keeper.function();
  SearchOptions options = long_search();
  options.evaluations = 50;
  searched(options, context);
  const int kept = keeper.count;
  options = long_search();
  const SearchResult fresh = searched(needs_suture, options);
  context.known = keeper.kept;
  const SearchResult more = searched(options, context);
  expect_same(more, fresh);
  EXPECT_GT(more.closures_known, 0);
  EXPECT_EQ(keeper.count - kept, more.closures - 1 - more.closures_known);
}

TEST(ResumedSearch, InterruptedAnywhereItEndsAsIfItHadNotBeen) {
  const SearchResult whole = searched(needs_suture, long_search());
  for (const int most : {0, 1, 33, 80, whole.evaluations + 5, whole.closures - 10}) {
    Keeper keeper;
    keeper.most = most;
    SearchContext context = context_of(needs_suture);
    context.keep = keeper.function();
    EXPECT_THROW((void)search_plans(fitting_valve(), long_search(), context), std::runtime_error);
    Keeper rest;
    context.known = keeper.kept;
    context.keep = rest.function();
    const SearchResult resumed = searched(long_search(), context);
    expect_same(resumed, whole);
    EXPECT_EQ(resumed.closures_known, most);
    EXPECT_EQ(rest.count, whole.closures - 1 - most);
  }
}

TEST(ResumedSearch, GivesUpAtTheFirstClosureThatCannotBeKept) {
  SearchOptions options = long_search();
  options.threads = 1;
  for (const int most : {0, 33, 280}) {  // of a search of 293, before its ranking and in it
    Keeper keeper;
    keeper.most = most;
    SearchContext context = context_of(needs_suture);
    context.keep = keeper.function();
    EXPECT_THROW((void)search_plans(fitting_valve(), options, context), std::runtime_error);
    EXPECT_EQ(keeper.count, most + 1) << "nothing more is tried";
  }
}

TEST(ResumedSearch, OwnPlansAreKnownAgainToo) {
  Keeper keeper;
  const std::vector<NamedPlan> plans = {{"ring", own_ring(2)},
                                        {"suture", suture(Side::Posteromedial, 22.0)}};
  SearchContext context = context_of(needs_suture);
  context.keep = keeper.function();
  const Expected<SearchResult> fresh =
      evaluate_plans(fitting_valve(), plans, small_search(), context);
  ASSERT_TRUE(fresh);
  EXPECT_EQ(keeper.count, 2 * 9);
  context.known = keeper.kept;
  const Expected<SearchResult> again =
      evaluate_plans(fitting_valve(), plans, small_search(), context);
  ASSERT_TRUE(again);
  expect_same(*again, *fresh);
  EXPECT_EQ(again->closures_known, 2 * 9);
  EXPECT_EQ(keeper.count, 2 * 9);
}

}  // namespace
}  // namespace coapt::scene
