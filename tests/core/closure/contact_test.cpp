#include "core/closure/contact.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace coapt {
namespace {

Vec3 random_point(std::mt19937& generator, double size) {
  std::uniform_real_distribution<double> uniform(0.0, size);
  return {uniform(generator), uniform(generator), uniform(generator)};
}

TEST(ClosestPoint, OfATriangleIsNoFurtherThanAnySampleOfIt) {
  std::mt19937 generator(1);
  for (int trial = 0; trial < 200; ++trial) {
    const Vec3 p = random_point(generator, 2.0), a = random_point(generator, 1.0),
               b = random_point(generator, 1.0), c = random_point(generator, 1.0);
    const Vec3 w = closest_point_weights(p, a, b, c);
    EXPECT_NEAR(w.sum(), 1.0, 1e-12);
    EXPECT_GE(w.minCoeff(), 0.0);
    const double distance = (p - w[0] * a - w[1] * b - w[2] * c).norm();
    double sampled = 1e9;
    for (int i = 0; i <= 40; ++i)
      for (int j = 0; i + j <= 40; ++j) {
        const double u = i / 40.0, v = j / 40.0;
        sampled = std::min(sampled, (p - (1.0 - u - v) * a - u * b - v * c).norm());
      }
    EXPECT_LE(distance, sampled + 1e-12);
    EXPECT_GE(distance, sampled - 0.05);
  }
}

TEST(ClosestPoint, OfTwoSegmentsIsNoFurtherThanAnySampleOfThem) {
  std::mt19937 generator(2);
  for (int trial = 0; trial < 200; ++trial) {
    const Vec3 a = random_point(generator, 1.0), b = random_point(generator, 1.0),
               c = random_point(generator, 1.0), d = random_point(generator, 1.0);
    const auto [s, t] = closest_point_shares(a, b, c, d);
    ASSERT_TRUE(s >= 0.0 && s <= 1.0 && t >= 0.0 && t <= 1.0);
    const double distance = (a + s * (b - a) - c - t * (d - c)).norm();
    double sampled = 1e9;
    for (int i = 0; i <= 60; ++i)
      for (int j = 0; j <= 60; ++j)
        sampled = std::min(sampled, (a + i / 60.0 * (b - a) - c - j / 60.0 * (d - c)).norm());
    EXPECT_LE(distance, sampled + 1e-12);
    EXPECT_GE(distance, sampled - 0.05);
  }
}

TEST(Overlapping, FindsWhatComparingAllBoxesFinds) {
  std::mt19937 generator(3);
  const auto random_boxes = [&](int count) {
    Boxes boxes{Points(count, 3), Points(count, 3)};
    for (int i = 0; i < count; ++i) {
      boxes.low_mm.row(i) = random_point(generator, 10.0);
      boxes.high_mm.row(i) = boxes.low_mm.row(i) + random_point(generator, 2.0).transpose();
    }
    return boxes;
  };
  for (int trial = 0; trial < 20; ++trial) {
    const Boxes a = random_boxes(80), b = random_boxes(120);
    std::vector<std::pair<int, int>> brute;
    for (int i = 0; i < 80; ++i)
      for (int j = 0; j < 120; ++j)
        if ((a.low_mm.row(i).array() <= b.high_mm.row(j).array()).all() &&
            (b.low_mm.row(j).array() <= a.high_mm.row(i).array()).all())
          brute.emplace_back(i, j);
    EXPECT_GT(brute.size(), 20u);
    std::vector<std::pair<int, int>> found = overlapping(a, b);
    std::sort(found.begin(), found.end());
    EXPECT_EQ(found, brute);
  }
}

/// A horizontal triangle of edge 10 mm and a vertex 0.6 mm above its middle; at rest 5 mm above.
ClosureModel vertex_over_triangle() {
  ClosureModel model;
  model.vertices = 4;
  model.faces.resize(1, 3);
  model.faces << 0, 1, 2;
  model.rest_mm.resize(4, 3);
  model.rest_mm << 0, 0, 0, 10, 0, 0, 0, 10, 0, 3, 3, 5;
  model.area_mm2 = {1.0, 1.0, 1.0, 2.0};
  return model;
}

TEST(Contact, PressureIsStiffnessTimesSquaredDepthOnTheVertexArea) {
  const ClosureModel model = vertex_over_triangle();
  Points x = model.rest_mm;
  x(3, 2) = 0.6;
  Points force = Points::Zero(4, 3);
  Contact(ContactLaw{1.0, 0.5, false}).add_forces(model, x, force);
  const double expected = 0.5 * 2.0 * 0.4 * 0.4;  // N
  EXPECT_NEAR(force(3, 2), expected, 1e-12);
  EXPECT_NEAR(force(0, 2), -0.4 * expected, 1e-12);  // weights 0.4, 0.3, 0.3 of (3, 3)
  EXPECT_NEAR(force(1, 2), -0.3 * expected, 1e-12);
  EXPECT_NEAR(force.colwise().sum().norm(), 0.0, 1e-12);
}

TEST(Contact, OfALeafletWithItselfCanBeLeftOut) {
  ClosureModel model = vertex_over_triangle();
  model.faces.conservativeResize(2, 3);
  model.faces.row(1) << 3, 4, 5;  // another triangle, 5 mm above at rest
  model.vertices = 6;
  model.rest_mm.conservativeResize(6, 3);
  model.rest_mm.bottomRows(2) << 13, 3, 5, 3, 13, 5;
  model.area_mm2.resize(6, 2.0);
  Points x = model.rest_mm;
  x(3, 2) = 0.6;
  const auto touches = [&](int below, int above, SelfContact self) {
    model.leaflet = {below, above};
    Points force = Points::Zero(6, 3);
    Contact(ContactLaw{1.0, 0.5, false, self}).add_forces(model, x, force);
    return force(3, 2) > 0.0;
  };
  for (int below = 0; below < kLeaflets; ++below)
    for (int above = 0; above < kLeaflets; ++above) {
      EXPECT_TRUE(touches(below, above, SelfContact::All));
      EXPECT_EQ(touches(below, above, SelfContact::NotAnterior), below != above || below != 0);
      EXPECT_EQ(touches(below, above, SelfContact::None), below != above);
    }
}

TEST(Contact, TouchesAddUpToTheForces) {
  const ClosureModel model = vertex_over_triangle();
  Points x = model.rest_mm;
  x.row(3) << 3.0, 4.0, 0.3;
  Points force = Points::Zero(4, 3), sum = force;
  Contact contact(ContactLaw{1.0, 0.5, false});
  contact.add_forces(model, x, force);
  const std::vector<Touch> touches = contact.touches(model, x);
  ASSERT_EQ(touches.size(), 1u);
  const Touch& touch = touches.front();
  EXPECT_NEAR(touch.gap_mm, 0.7, 1e-12);
  EXPECT_NEAR((touch.direction - Vec3(0, 0, 1)).norm(), 0.0, 1e-12);
  for (std::size_t k = 0; k < 4; ++k)
    sum.row(touch.nodes[k]) += touch.weights[k] * touch.force_n_per_mm2 * touch.gap_mm *
                               touch.gap_mm * touch.direction.transpose();
  EXPECT_NEAR((sum - force).norm(), 0.0, 1e-15);
  x(3, 2) = 1.1;
  EXPECT_TRUE(contact.touches(model, x).empty());
}

TEST(Contact, IsNothingAtItsThicknessAndGrowsFromThereWithoutAStep) {
  const ClosureModel model = vertex_over_triangle();
  for (const auto& [height, expected] : {std::pair{1.0, 0.0}, {0.999, 1e-6}, {1.4, 0.0}}) {
    Points x = model.rest_mm;
    x(3, 2) = height;
    Points force = Points::Zero(4, 3);
    Contact(ContactLaw{1.0, 0.5, false}).add_forces(model, x, force);
    EXPECT_NEAR(force(3, 2), expected, 1e-9);
  }
}

TEST(Contact, ListStaysTrueWhileNodesMove) {
  const ClosureModel model = vertex_over_triangle();
  Contact kept(ContactLaw{1.0, 0.5, false});
  Points x = model.rest_mm;
  for (int step = 0; step < 60; ++step) {
    x(3, 2) = 5.0 - 0.08 * step;
    x(3, 0) = 3.0 + 0.02 * step;
    Points with_list = Points::Zero(4, 3), fresh = Points::Zero(4, 3);
    kept.add_forces(model, x, with_list);
    Contact(ContactLaw{1.0, 0.5, false}).add_forces(model, x, fresh);
    EXPECT_EQ(with_list, fresh) << "step " << step;
  }
}

TEST(Contact, BetweenCrossedEdgesPushesThemApart) {
  ClosureModel model;
  model.vertices = 4;
  model.faces.resize(0, 3);
  model.rest_mm.resize(4, 3);
  model.rest_mm << -5, 0, 0, 5, 0, 0, 0, -5, 9, 0, 5, 9;
  model.area_mm2 = {1.0, 1.0, 1.0, 1.0};
  model.edges = {{0, 1}, {2, 3}};
  Points x = model.rest_mm;
  x(2, 2) = x(3, 2) = 0.25;
  Points force = Points::Zero(4, 3);
  Contact(ContactLaw{1.0, 0.8, true}).add_forces(model, x, force);
  // On a quarter of the four vertex areas. From 0.5 mm on and four times as stiff: half way in, a
  // quarter of the pressure at distance 0, as between a vertex and a face.
  const double expected = 0.25 * 0.8;
  EXPECT_NEAR(force(2, 2) + force(3, 2), expected, 1e-12);
  EXPECT_NEAR(force(0, 2), -0.5 * expected, 1e-12);
}

TEST(Contact, OfEdgesIsOfGuardedFacesAloneIfTheLawHasNone) {
  // Two upright triangles whose upper and lower edges cross 0.25 mm apart.
  ClosureModel model;
  model.vertices = 6;
  model.faces.resize(2, 3);
  model.faces << 0, 1, 2, 3, 4, 5;
  model.rest_mm.resize(6, 3);
  model.rest_mm << -5, 0, 0, 5, 0, 0, 0, 0, -8, 0, -5, 9, 0, 5, 9, 0, 0, 17;
  model.area_mm2.assign(6, 1.0);
  model.edges = {{0, 1}, {0, 2}, {1, 2}, {3, 4}, {3, 5}, {4, 5}};
  Points x = model.rest_mm;
  x.bottomRows(3).col(2).array() -= 8.75;
  const auto push_n = [&](bool all, const std::vector<int>& guarded) {
    Points force = Points::Zero(6, 3);
    Contact(ContactLaw{1.0, 0.8, all}, guarded).add_forces(model, x, force);
    return force.bottomRows(3).col(2).sum();
  };
  EXPECT_NEAR(push_n(true, {}), 0.25 * 0.8, 1e-12);
  EXPECT_NEAR(push_n(false, {0, 1}), 0.25 * 0.8, 1e-12);
  EXPECT_EQ(push_n(false, {1}), 0.0);
  EXPECT_EQ(push_n(false, {}), 0.0);
}

}  // namespace
}  // namespace coapt
