#include "search/studies/generality.h"

#include <gtest/gtest.h>

#include "core/valve/validate.h"

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

TEST(RandomAnatomies, AreValidAndTheSameForAnyNumberOfThreads) {
  const RandomAnatomies one = random_anatomies(1, 4, 1), two = random_anatomies(1, 4, 2);
  ASSERT_EQ(one.valves.size(), 1u);
  ASSERT_EQ(two.valves.size(), 1u);
  EXPECT_EQ(one.drawn, two.drawn);
  EXPECT_EQ(one.drawn % 16, 0);
  EXPECT_TRUE(validate(one.valves[0]).empty());
  EXPECT_EQ(one.valves[0].name, two.valves[0].name);
  EXPECT_EQ(one.valves[0].rest_mm, two.valves[0].rest_mm);
  EXPECT_TRUE(random_anatomies(0, 4, 1).valves.empty());
}

}  // namespace
}  // namespace coapt
