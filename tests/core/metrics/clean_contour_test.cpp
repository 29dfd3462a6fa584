#include "core/metrics/clean_contour.h"

#include <gtest/gtest.h>

namespace coapt {
namespace {

TEST(CleanContour, KeepsTheCornersOfASquareAlone) {
  const std::vector<Vec2> cleaned = clean_contour(
      {{0, 0}, {2, 0.005}, {4, 0}, {4, 4}, {4.003, 4.004}, {1, 4}, {0, 4}, {0, 1}}, 0.01);
  ASSERT_EQ(cleaned.size(), 4u);
  EXPECT_NEAR(polygon_area(cleaned), 16.0, 0.02);
}

TEST(CleanContour, ASpikeGoes) {
  const std::vector<Vec2> cleaned =
      clean_contour({{0, 0}, {4, 0}, {4, 2}, {9, 2.001}, {4, 2.002}, {4, 4}, {0, 4}}, 0.01);
  ASSERT_EQ(cleaned.size(), 4u);
  EXPECT_NEAR(polygon_area(cleaned), 16.0, 1e-9);
}

TEST(CleanContour, NothingIsLeftOfASpeckOrALine) {
  EXPECT_TRUE(clean_contour({{0, 0}, {0.005, 0}, {0, 0.005}}, 0.01).empty());
  EXPECT_TRUE(clean_contour({{0, 0}, {3, 0}, {5, 0}, {2, 0}}, 0.01).empty());
  EXPECT_TRUE(clean_contour({}, 0.01).empty());
}

}  // namespace
}  // namespace coapt
