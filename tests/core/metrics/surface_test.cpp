#include "core/metrics/surface.h"

#include <gtest/gtest.h>

#include <random>

#include "core/closure/contact.h"

namespace coapt {
namespace {

std::vector<SurfaceTriangle> random_triangles(int count, std::mt19937& random) {
  std::uniform_real_distribution<double> coordinate(-10.0, 10.0);
  const auto point = [&] {
    return Vec3(coordinate(random), coordinate(random), coordinate(random));
  };
  std::vector<SurfaceTriangle> triangles;
  for (int i = 0; i < count; ++i) {
    const Vec3 corner = point();
    triangles.push_back({corner, corner + 0.3 * point(), corner + 0.3 * point()});
  }
  return triangles;
}

TEST(Surface, DistanceIsThatOfTheNearestTriangleUpToTheLimit) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> coordinate(-12.0, 12.0);
  const std::vector<SurfaceTriangle> triangles = random_triangles(40, random);
  const TriangleSet surface = make_surface(triangles);
  for (int i = 0; i < 500; ++i) {
    const Vec3 p(coordinate(random), coordinate(random), coordinate(random));
    double nearest = 1e300;
    for (const auto& [a, b, c] : triangles) {
      const Vec3 w = closest_point_weights(p, a, b, c);
      nearest = std::min(nearest, (p - w[0] * a - w[1] * b - w[2] * c).norm());
    }
    EXPECT_NEAR(distance_within(surface, p, 1e9), nearest, 1e-12);
    EXPECT_NEAR(distance_within(surface, p, 2.0), std::min(nearest, 2.0), 1e-12);
    EXPECT_NEAR((nearest_point(surface, p) - p).norm(), nearest, 1e-12);
  }
}

TEST(Surface, AHintChangesNoDistance) {
  std::mt19937 random(4);
  const TriangleSet surface = make_surface(random_triangles(60, random));
  const Vec3 point(1.0, -2.0, 3.0);
  const SurfacePoint nearest = nearest_within(surface, point, 1e9);
  EXPECT_EQ(distance_to(surface, point, nearest.triangle), nearest.distance_mm);
  for (int hint = 0; hint < 60; ++hint)
    EXPECT_EQ(nearest_within(surface, point, 1e9, hint).distance_mm, nearest.distance_mm);
}

TEST(Surface, WithoutTrianglesEverythingIsAsFarAsTheLimit) {
  const SurfacePoint nearest = nearest_within(make_surface({}), Vec3::UnitX(), 5.0);
  EXPECT_EQ(nearest.distance_mm, 5.0);
  EXPECT_EQ(nearest.triangle, -1);
}

}  // namespace
}  // namespace coapt
