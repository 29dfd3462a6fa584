#include "core/metrics/outline.h"

#include <gtest/gtest.h>

namespace coapt {
namespace {

using Walks = std::vector<std::vector<int>>;

TEST(Outline, OfASquareOfTwoFacesIsItsFourSides) {
  EXPECT_EQ(outline({{0, 1, 2}, {0, 2, 3}}), (Walks{{0, 1, 2, 3}}));
}

TEST(Outline, OfARingIsTwoWalksThatRunOppositeWays) {
  // Outer triangle 0 1 2, inner triangle 3 4 5.
  const Walks walks = outline({{0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4}, {2, 0, 3}, {2, 3, 5}});
  EXPECT_EQ(walks, (Walks{{0, 1, 2}, {3, 5, 4}}));
}

TEST(Outline, EveryEdgeOfFacesThatMeetInACornerIsKept) {
  std::size_t edges = 0;
  for (const std::vector<int>& walk : outline({{0, 1, 2}, {2, 3, 4}})) edges += walk.size();
  EXPECT_EQ(edges, 6u);
}

TEST(Outline, AFaceThereTwiceWindsTwice) { EXPECT_EQ(outline({{0, 1, 2}, {0, 1, 2}}).size(), 2u); }

TEST(Outline, OfNothingOrOfAClosedSurfaceIsNothing) {
  EXPECT_TRUE(outline({}).empty());
  EXPECT_TRUE(outline({{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}}).empty());
}

}  // namespace
}  // namespace coapt
