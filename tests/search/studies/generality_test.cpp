#include "search/studies/generality.h"

#include <gtest/gtest.h>

#include <random>

#include "core/metrics/leak.h"
#include "core/presets/presets.h"
#include "core/valve/validate.h"
#include "search/plans/objective.h"
#include "search/random_share.h"

namespace coapt {
namespace {

Finding finding(const std::string& name, bool agrees) { return {name, "4.3", "", "", "", agrees}; }

const FindingShare& share_of(const std::vector<FindingShare>& shares, const std::string& name,
                             const std::string& kind) {
  for (const FindingShare& share : shares)
    if (share.finding == name && share.kind == kind) return share;
  ADD_FAILURE() << name << " of " << kind;
  return shares.front();
}

TEST(FindingShares, CountWhereAFindingCouldBeAskedByKindAndInAll) {
  const std::vector<FindingShare> shares =
      finding_shares({{"human", "a", {finding("x", true), finding("y", false)}},
                      {"human", "b", {finding("x", false)}},
                      {"porcine", "c", {finding("x", true), finding("y", true)}}});
  ASSERT_EQ(shares.size(), 2u * 3u);
  const auto expect = [&](const char* name, const char* kind, int agree, int valves) {
    const FindingShare& share = share_of(shares, name, kind);
    EXPECT_EQ(share.agree, agree) << name << ' ' << kind;
    EXPECT_EQ(share.valves, valves) << name << ' ' << kind;
  };
  expect("x", "", 2, 3);
  expect("x", "human", 1, 2);
  expect("x", "porcine", 1, 1);
  expect("y", "", 1, 2);
  expect("y", "human", 0, 1);
  expect("y", "porcine", 1, 1);
  EXPECT_EQ(shares.front().finding, "x");
  EXPECT_EQ(shares.front().kind, "");
  EXPECT_TRUE(finding_shares({}).empty());
}

/// One after the other.
Valve first_competent(std::uint64_t seed) {
  std::mt19937_64 engine(seed);
  for (int i = 0;; ++i) {
    std::vector<double> shares(kAnatomyParameters);
    for (double& share : shares) share = random_share(engine);
    const Expected<Valve> valve =
        make_taut_valve(parametric_valve(anatomy_at(shares), "random-" + std::to_string(i)));
    if (!valve) continue;
    const ClosureResult closure = close_valve(*valve);
    if (trusted(closure) && measure_leak(*valve, closure.closed_mm).area_mm2 <= kMildLeak_mm2)
      return *valve;
  }
}

TEST(RandomAnatomies, AreValidAndTheSameForAnyNumberOfThreads) {
  constexpr std::uint64_t kSeed = 4;
  const RandomAnatomies found = random_anatomies(1, kSeed, 2);
  ASSERT_EQ(found.valves.size(), 1u);
  EXPECT_EQ(found.drawn % 16, 0);
  EXPECT_TRUE(validate(found.valves[0]).empty());
  const Valve first = first_competent(kSeed);
  EXPECT_EQ(found.valves[0].name, first.name);
  EXPECT_EQ(found.valves[0].rest_mm, first.rest_mm);
  EXPECT_EQ(found.valves[0].chordae, first.chordae);
  EXPECT_TRUE(random_anatomies(0, kSeed, 1).valves.empty());
}

}  // namespace
}  // namespace coapt
