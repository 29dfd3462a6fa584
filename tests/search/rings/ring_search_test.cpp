// A search whose valves are a formula: the leak grows with the distance from a known best ring.
#include "search/rings/ring_search.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>

#include "search/rings/design_ring.h"
#include "tests/scenes/small_valve.h"

namespace coapt {
namespace {

constexpr RingTerms kBest{.ap_over_transverse = 0.65, .p3_inset = 0.04, .saddle = 0.12};

std::vector<RingMember> members(int count) {
  std::vector<RingMember> list;
  for (int i = 0; i < count; ++i)
    list.push_back(
        {"member-" + std::to_string(i), i % 3 == 0 ? "ischaemic" : "dilated", small_valve()});
  return list;
}

/// 100 mm2 for each squared distance of all ranges from the best; 30 mm is the best size of an annulus of 36 mm.
double leak_of(const Annuloplasty& step) {
  const auto* ring = std::get_if<DesignedRing>(&step.ring);
  if (ring == nullptr) return 9.0;
  double leak = 0.0;
  for (const RingTermRow& row : kRingTerms) {
    const double width = row.range.max - row.range.min;
    leak += 100.0 * std::pow((ring->shape.terms.*row.member - kBest.*row.member) / width, 2.0);
  }
  return leak + std::abs(ring->size_mm - 30.0);
}

RingOutcome formula(const RingMember&, const Annuloplasty& step, const RingQuestion& question) {
  RingOutcome outcome;
  outcome.is_possible = true;
  outcome.leaks_mm2.assign(question.disturbances.size(), leak_of(step));
  if (question.durability) outcome.durability_mm = 4.0;
  return outcome;
}

RingSearchOptions options() {
  return {.evaluations = 6000, .seed = 3, .threads = 1, .disturbances = {0, 1, 2}};
}

TEST(RingSearch, FindsAKnownBest) {
  const auto found = search_ring(formula, members(12), "mine", options());
  ASSERT_TRUE(found);
  EXPECT_EQ(found->design.shape.name, "mine");
  const RingTerms& terms = found->design.shape.terms;
  EXPECT_NEAR(terms.ap_over_transverse, 0.65, 0.05);
  EXPECT_NEAR(terms.saddle, 0.12, 0.04);
  EXPECT_NEAR(terms.p3_inset, 0.04, 0.03);
  EXPECT_EQ(ring_size_mm(found->design.width_over_transverse, 36.0), 30.0);
  EXPECT_LT(found->cost, found->generic.cost);
  EXPECT_LE(found->evaluations, 1.1 * options().evaluations);
  EXPECT_EQ(unsewable(terms), 0.0);
}

TEST(RingSearch, ThreadsDoNotChangeTheRing) {
  RingSearchOptions few = options();
  few.evaluations = 3000;
  const auto one = search_ring(formula, members(10), "mine", few);
  few.threads = 3;
  const auto three = search_ring(formula, members(10), "mine", few);
  EXPECT_EQ(one->design, three->design);
  EXPECT_EQ(one->cost, three->cost);
  EXPECT_EQ(one->generic.candidate, three->generic.candidate);
  few.seed = 4;
  EXPECT_NE(search_ring(formula, members(10), "mine", few)->design, one->design);
}

TEST(RingSearch, EndsWhenItIsCancelled) {
  const std::atomic<bool> cancelled = true;
  RingSearchOptions stopped = options();
  stopped.cancelled = &cancelled;
  EXPECT_FALSE(search_ring(formula, members(4), "mine", stopped));
}

// Generic rings leak 9 mm2 everywhere, the best less than 5: every closure of every held-out member is gained.
TEST(DesignRing, GainsOnMembersThatItsSearchNeverSaw) {
  std::atomic<int> held_out_early = 0;
  std::atomic<bool> is_searching = true;
  const RingTrial trial = [&](const RingMember& member, const Annuloplasty& step,
                              const RingQuestion& question) {
    if (question.durability && question.disturbances.back() > 1288) is_searching = false;
    const int index = std::stoi(member.name.substr(7));
    if (is_searching && index % 2 == 1) ++held_out_early;
    return formula(member, step, question);
  };
  RingDesignOptions few{.evaluations = 3000, .seed = 1, .threads = 1};
  const auto designed = design_ring_by(trial, members(9), "mine", few);
  ASSERT_TRUE(designed && *designed);
  const RingDesignResult& result = **designed;
  EXPECT_EQ(result.searched_members, 5);
  EXPECT_EQ(result.held_out_members, 4);
  EXPECT_EQ(held_out_early, 0);
  ASSERT_EQ(result.verdicts.size(), 3u);  // all, and two aetiologies
  EXPECT_EQ(result.verdicts[0].below_percent.mean, 100.0);
  EXPECT_EQ(result.verdicts[0].generic.below_percent, 0.0);
  EXPECT_EQ(result.claims.sizes.size(), 9u);
}

TEST(RingCost, NarrowUndersizedAndLeakingValvesCountAlike) {
  RingOutcome good;
  good.is_possible = true;
  good.leaks_mm2 = {0.0};
  RingOutcome leaking = good, narrow = good, undersized = good;
  leaking.leaks_mm2 = {30.0};
  narrow.gradient_mmhg = 9.0;
  undersized.sizes_below = 6.0;
  for (const RingOutcome& bad : {leaking, narrow, undersized})
    EXPECT_NEAR(ring_cost(bad) - ring_cost(good), 1.0, 0.2);
  EXPECT_GT(ring_cost(RingOutcome{}), ring_cost(leaking)) << "a ring that cannot be sewn in";
  leaking.leaks_mm2 = {std::nan(""), 0.0};
  EXPECT_EQ(share_below(leaking), 0.5) << "what cannot be trusted leaks";
  EXPECT_EQ(mean_leak_mm2(leaking), 50.0);
}

}  // namespace
}  // namespace coapt
