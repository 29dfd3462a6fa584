#include "core/metrics/raster.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace coapt {
namespace {

Mask full_mask(int width, int height) {
  return {width, height, std::vector<std::uint8_t>(width * height, 1)};
}

bool is_set(const Mask& mask, int column, int row) {
  return mask.pixels[row * mask.width + column] != 0;
}

Triangle random_triangle(std::mt19937& random, double low, double high) {
  std::uniform_real_distribution<double> coordinate(low, high);
  Triangle triangle;
  for (Vec2& corner : triangle) corner = {coordinate(random), coordinate(random)};
  return triangle;
}

double distance_to_segment(const Vec2& point, const Vec2& a, const Vec2& b) {
  const double t = (point - a).dot(b - a) / (b - a).squaredNorm();
  return (point - a - std::clamp(t, 0.0, 1.0) * (b - a)).norm();
}

double distance(const Vec2& point, const Triangle& triangle) {
  double nearest = 1e300;
  int left = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec2 a = triangle[i], b = triangle[(i + 1) % 3];
    nearest = std::min(nearest, distance_to_segment(point, a, b));
    if ((b - a).x() * (point - a).y() > (b - a).y() * (point - a).x()) ++left;
  }
  return (left == 0 || left == 3) && nearest > 1e-9 ? 0.0 : nearest;
}

TEST(Raster, GrownTrianglesAgreeWithTheDistanceOfEveryPixelCentre) {
  std::mt19937 random(7);
  for (int trial = 0; trial < 200; ++trial) {
    const double radius = trial % 4 == 0 ? 0.0 : 0.1 * (trial % 90);
    Triangle triangle = random_triangle(random, -10.0, 60.0);
    if (trial % 5 == 1) triangle[2] = triangle[1] + Vec2(1e-7, 0.0);  // all but seen edge-on
    Mask mask = full_mask(50, 40);
    cover_triangles(mask, {triangle}, radius);
    for (int row = 0; row < mask.height; ++row)
      for (int column = 0; column < mask.width; ++column) {
        const double gap = distance({column + 0.5, row + 0.5}, triangle) - radius;
        if (std::abs(gap) < 1e-9) continue;  // on the outline, where either is right
        ASSERT_EQ(is_set(mask, column, row), gap > 0.0) << trial;
      }
  }
}

TEST(Raster, TrianglesThatShareEdgesLeaveNoPixelBetweenThem) {
  std::mt19937 random(11);
  for (int trial = 0; trial < 300; ++trial) {
    // A fan about a point, on pixel centres and at random: its pixels are those of its outline.
    const Vec2 centre = trial % 2 ? Vec2(20.5, 15.5) : random_triangle(random, 15.0, 20.0)[0];
    const std::vector<Vec2> outline = {{1.5, 1.5},   {20.5, 0.5},  {38.5, 2.5},
                                       {39.2, 28.5}, {20.5, 29.5}, {0.7, 27.1}};
    Mask inside = full_mask(40, 30);
    std::fill(inside.pixels.begin(), inside.pixels.end(), std::uint8_t{0});
    mark_polygon(inside, outline);
    for (std::size_t i = 0; i < outline.size(); ++i)
      cover_triangles(inside, {{outline[i], centre, outline[(i + 1) % outline.size()]}}, 0.0);
    ASSERT_EQ(std::count(inside.pixels.begin(), inside.pixels.end(), 1), 0) << trial;
  }
}

TEST(Raster, ASheetSeenEdgeOnCoversNothingButItsThickness) {
  const Triangle sheet = {Vec2(10.2, 5.2), Vec2(10.2, 25.2), Vec2(10.2, 15.0)};
  Mask bare = full_mask(30, 30);
  cover_triangles(bare, {sheet}, 0.0);
  EXPECT_EQ(std::count(bare.pixels.begin(), bare.pixels.end(), 0), 0);
  Mask grown = full_mask(30, 30);
  cover_triangles(grown, {sheet}, 3.0);
  for (int column = 0; column < 30; ++column)  // centres from 7.2 to 13.2
    EXPECT_EQ(is_set(grown, column, 15), column < 7 || column > 12) << column;
}

TEST(Raster, APolygonMarksThePixelsWhoseCentresItHolds) {
  Mask mask{8, 6, std::vector<std::uint8_t>(48, 0)};
  // An L: 6 x 4 without its upper right 3 x 2.
  const int count = mark_polygon(mask, {{1, 1}, {4, 1}, {4, 3}, {7, 3}, {7, 5}, {1, 5}});
  EXPECT_EQ(count, 18);
  EXPECT_TRUE(is_set(mask, 3, 1));
  EXPECT_FALSE(is_set(mask, 4, 1));
  EXPECT_TRUE(is_set(mask, 6, 4));
  EXPECT_FALSE(is_set(mask, 0, 4));
  EXPECT_EQ(std::count(mask.pixels.begin(), mask.pixels.end(), 1), 18);
}

TEST(Raster, TrianglesFarAwayOrUnboundedAreHarmless) {
  Mask mask = full_mask(10, 10);
  cover_triangles(mask, {{Vec2(1e300, 1e300), Vec2(1e301, 0.0), Vec2(1e300, -1e300)}}, 2.0);
  cover_triangles(mask, {{Vec2(-50, -50), Vec2(-40, 90), Vec2(-30, 3)}}, 2.0);
  EXPECT_EQ(std::count(mask.pixels.begin(), mask.pixels.end(), 0), 0);
}

}  // namespace
}  // namespace coapt
