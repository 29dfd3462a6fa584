#include "core/metrics/surface_tree.h"

#include <gtest/gtest.h>

#include <random>

#include "core/closure/contact.h"
#include "tests/core/metrics/shape_scene.h"

namespace coapt {
namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();

/// Triangles that share nothing, in a box of 20 mm.
SurfaceTree random_surface(int count, std::mt19937& random) {
  std::uniform_real_distribution<double> coordinate(-10.0, 10.0);
  const auto point = [&] {
    return Vec3(coordinate(random), coordinate(random), coordinate(random)).transpose().eval();
  };
  Points vertices(3 * count, 3);
  Faces faces(count, 3);
  for (int i = 0; i < count; ++i) {
    const auto corner = point();
    vertices.middleRows<3>(3 * i) << corner, corner + 0.3 * point(), corner + 0.3 * point();
    faces.row(i) << 3 * i, 3 * i + 1, 3 * i + 2;
  }
  return {vertices, faces};
}

SurfaceTree surface_of_mesh(const LeafletMesh& mesh) { return {mesh.vertices_mm, mesh.faces}; }

/// As the nearest point by going through all faces.
void expect_nearest(const SurfaceTree& tree, const Vec3& point) {
  double least_mm = kFar;
  int least = -1;
  for (int face = 0; face < tree.faces().rows(); ++face)
    if (const double away_mm = tree.distance_mm(point, face); away_mm < least_mm) {
      least_mm = away_mm;
      least = face;
    }
  const TreePoint nearest = tree.nearest(point);
  EXPECT_EQ(nearest.distance_mm, least_mm);
  EXPECT_EQ(nearest.face, least);
  EXPECT_NEAR((nearest.point_mm - point).norm(), least_mm, 1e-12);
  const Points corners = tree.vertices_mm()(tree.faces().row(least), Eigen::all);
  EXPECT_NEAR((corners.transpose() * nearest.weights - nearest.point_mm).norm(), 0.0, 1e-12);
  EXPECT_EQ(tree.nearest(point, 2.0).distance_mm, std::min(least_mm, 2.0));
}

TEST(SurfaceTree, FindsTheNearestPointThatGoingThroughAllTrianglesFinds) {
  std::mt19937 random(3);
  const SurfaceTree tree = random_surface(40, random);
  std::uniform_real_distribution<double> coordinate(-12.0, 12.0);
  for (int i = 0; i < 500; ++i)
    expect_nearest(tree, {coordinate(random), coordinate(random), coordinate(random)});
}

TEST(SurfaceTree, FindsTheSmallestNumberOfFacesThatShareTheNearestPoint) {
  const SurfaceTree tree = surface_of_mesh(bowl());
  for (int i = 0; i < 200; ++i)
    expect_nearest(tree,
                   {20.0 * std::sin(1.7 * i), 15.0 * std::sin(2.9 * i), 12.0 * std::sin(0.7 * i)});
}

TEST(SurfaceTree, ItsDistanceToAFaceIsThatOfTheClosestPoint) {
  std::mt19937 random(5);
  const SurfaceTree tree = random_surface(1, random);
  const Vec3 point(1.0, -2.0, 3.0), a = tree.vertices_mm().row(0), b = tree.vertices_mm().row(1),
                                    c = tree.vertices_mm().row(2);
  const Vec3 w = closest_point_weights(point, a, b, c);
  EXPECT_NEAR(tree.distance_mm(point, 0), (point - w[0] * a - w[1] * b - w[2] * c).norm(), 1e-12);
  EXPECT_EQ(tree.distance_mm(point, -1), kFar);
}

TEST(SurfaceTree, AHintChangesNothing) {
  std::mt19937 random(4);
  const SurfaceTree tree = random_surface(60, random);
  const Vec3 point(1.0, -2.0, 3.0);
  const TreePoint nearest = tree.nearest(point);
  for (int hint = 0; hint < 60; ++hint) {
    EXPECT_EQ(tree.nearest(point, 1e9, hint).distance_mm, nearest.distance_mm);
    EXPECT_EQ(tree.nearest(point, 1e9, hint).face, nearest.face);
  }
}

TEST(SurfaceTree, WithoutFacesEverythingIsAsFarAsTheLimit) {
  const TreePoint nearest = SurfaceTree(Points(0, 3), Faces(0, 3)).nearest(Vec3::UnitX(), 5.0);
  EXPECT_EQ(nearest.distance_mm, 5.0);
  EXPECT_EQ(nearest.face, -1);
}

TEST(SurfaceTree, LeavesOutFacesThatDoNotCountAndThoseBeyondTheLimit) {
  const SurfaceTree tree = surface_of_mesh(plane({0.0, 2.0, 0.0, 1.0, 2, 1}, 0.0));
  const auto from_second_cell = [](int face) { return face >= 2; };
  EXPECT_NEAR(tree.nearest_within({0.5, 0.5, 0.0}, 10.0, from_second_cell).distance_mm, 0.5, 1e-12);
  EXPECT_EQ(tree.nearest_within({0.5, 0.5, 0.0}, 0.4, from_second_cell).face, -1);
}

TEST(SurfaceTree, LooksAtATriangleThatIsThereAgainAndAgainOnce) {
  // All that the other 50,000 tell is which numbers count.
  Points vertices(3, 3);
  vertices << 0.0, 0.0, 0.0, 4.0, 0.0, 0.0, 0.0, 4.0, 4.0;
  const SurfaceTree tree(vertices, Eigen::RowVector3i(0, 1, 2).replicate(50'000, 1));
  int asked = 0;
  const auto from_third = [&](int face) { return ++asked, face >= 2; };
  EXPECT_EQ(tree.nearest_within({1.0, 1.0, 9.0}, kFar, from_third).face, 2);
  EXPECT_EQ(asked, 3);
  EXPECT_EQ(tree.nearest({1.0, 1.0, 9.0}).face, 0);
  EXPECT_EQ(tree.nearest({1.0, 1.0, 9.0}).distance_mm, tree.distance_mm({1.0, 1.0, 9.0}, 7));
  EXPECT_EQ(tree.nearest({1.0, 1.0, 9.0}, 0.5).face, -1);
}

TEST(SurfaceTree, LeavesRowsOutOnceCancelled) {
  const SurfaceTree tree = surface_of_mesh(bowl());
  int asked = 0;
  const auto third_time = [&] { return ++asked == 3; };
  EXPECT_EQ(nearest_to_each(tree, Points::Zero(1000, 3), third_time).size(), 128u);
  EXPECT_EQ(nearest_to_each(tree, Points::Zero(100, 3)).size(), 100u);
}

TEST(SurfaceEdge, HoldsTheBoundaryAndNothingElse) {
  const LeafletMesh mesh = plane({0.0, 2.0, 0.0, 2.0, 2, 2}, 0.0);
  const SurfaceTree tree = surface_of_mesh(mesh);
  const SurfaceEdge edge(mesh.faces);
  EXPECT_TRUE(edge.holds(tree.nearest({-1.0, 0.7, 0.0})));
  EXPECT_TRUE(edge.holds(tree.nearest({3.0, 3.0, 1.0})));
  EXPECT_FALSE(edge.holds(tree.nearest({1.0, 1.0, 1.0})));  // the vertex in the middle
  EXPECT_FALSE(edge.holds(tree.nearest({0.5, 0.5, 1.0})));  // on a diagonal
}

}  // namespace
}  // namespace coapt
