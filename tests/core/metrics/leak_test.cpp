#include "core/metrics/leak.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/closure/closure.h"
#include "tests/scenes/sheets.h"
#include "tests/scenes/small_preset.h"

namespace coapt {
namespace {

constexpr double kHalf_mm = 0.5;  // of the scenes' thickness
constexpr double kShare = 0.03;   // of an area that is known exactly

/// A funnel of half a right angle, from a circle of 12 mm to a hole whose plane rises by `slope` along x.
Valve funnel(double hole_radius_mm, double slope) {
  Valve valve = disc_with_hole(12.0, hole_radius_mm);
  for (Index v = 0; v < valve.rest_mm.rows(); ++v) {
    const double depth = 12.0 - valve.rest_mm.row(v).head<2>().norm();
    valve.rest_mm(v, 2) = -depth + slope * valve.rest_mm(v, 0) * depth / (12.0 - hole_radius_mm);
  }
  return valve;
}

/// A plate with a slit of 20 mm across, w wide, for each y.
Valve slits(const std::vector<double>& middles, double width_mm) {
  std::vector<double> xs{-14.0, -12.0, -10.0}, ys{-14.0};
  for (double x = -8.0; x <= 14.0; x += 2.0) xs.push_back(x);
  for (const double y : middles) {
    for (double between = ys.back() + 2.0; between < y - width_mm / 2 - 0.5; between += 2.0)
      ys.push_back(between);
    ys.push_back(y - width_mm / 2);
    ys.push_back(y + width_mm / 2);
  }
  for (double y = ys.back() + 2.0; y < 13.5; y += 2.0) ys.push_back(y);
  ys.push_back(14.0);
  return grid_sheet(xs, ys, [&](int i, int j) {
    const double x = xs[static_cast<std::size_t>(i)], y = ys[static_cast<std::size_t>(j)];
    return x >= -10.0 && x < 10.0 &&
           std::any_of(middles.begin(), middles.end(),
                       [&](double middle) { return y == middle - width_mm / 2; });
  });
}

Leak leak_of(const Valve& valve) { return measure_leak(valve, valve.rest_mm); }

void expect_area(const Valve& valve, double area_mm2) {
  const Leak leak = leak_of(valve);
  EXPECT_NEAR(leak.area_mm2, area_mm2, kShare * area_mm2);
  EXPECT_LE(leak.lower_mm2, leak.area_mm2);
  EXPECT_GE(leak.upper_mm2, leak.area_mm2);
}

TEST(Leak, OfAPlateWithARoundHoleIsTheHoleLessHalfTheThickness) {
  for (const double radius : {2.0, 4.0, 7.0})
    expect_area(disc_with_hole(12.0, radius),
                std::numbers::pi * (radius - kHalf_mm) * (radius - kHalf_mm));
}

TEST(Leak, OfAFunnelIsItsNarrowEnd) { expect_area(funnel(5.0, 0.0), std::numbers::pi * 4.5 * 4.5); }

TEST(Leak, OfAFunnelCutAskewIsTheSurfaceAcrossItsEdge) {
  const double slope = 0.3, a = 5.0 * std::sqrt(1.0 + slope * slope), b = 5.0;
  const double round =
      std::numbers::pi *
      (3.0 * (a + b) - std::sqrt((3.0 * a + b) * (a + 3.0 * b)));  // Ramanujan 1914
  expect_area(funnel(5.0, slope),
              std::numbers::pi * (a * b + kHalf_mm * kHalf_mm) - kHalf_mm * round);
}

TEST(Leak, OfASlitIsWhatTheThicknessLeavesOfIt) {
  expect_area(slits({0.0}, 3.0), 19.0 * 2.0);
  expect_area(slits({0.25}, 1.6), 19.0 * 0.6);
  EXPECT_LT(leak_of(slits({0.0}, 1.0)).area_mm2, 0.1);
}

TEST(Leak, OfTwoSlitsHasTwoOpeningsWithTheirPlaces) {
  const Leak leak = leak_of(slits({-6.0, 5.0}, 2.0));
  ASSERT_EQ(leak.openings.size(), 2u);
  EXPECT_NEAR(leak.area_mm2, 2 * 19.0, kShare * 38.0);
  for (const LeakOpening& opening : leak.openings) {
    EXPECT_NEAR(opening.area_mm2, 19.0, 2.0 * kShare * 19.0);
    EXPECT_NEAR(opening.width_mm, 1.0, 0.3);
    EXPECT_GT(opening.normal.z(), 0.98);
    const bool is_anterior = opening.centroid_mm.y() > 0.0;
    EXPECT_NEAR(opening.centroid_mm.y(), is_anterior ? 5.0 : -6.0, 0.3);
    EXPECT_EQ(opening.segments.front(), is_anterior ? Segment::A2 : Segment::P2);
  }
}

TEST(Leak, TheSurfaceOfAnOpeningLiesAcrossItAndItsOutlineAtTheTissue) {
  for (const double slope : {0.0, 0.3}) {
    const Leak leak = leak_of(funnel(5.0, slope));
    ASSERT_EQ(leak.openings.size(), 1U);
    const OpeningSurface& surface = leak.openings[0].surface;
    Vec3 normal = Vec3::Zero();
    double area = 0.0;
    for (const auto& face : surface.faces.rowwise()) {
      const Vec3 a = surface.points_mm.row(face[0]), b = surface.points_mm.row(face[1]),
                 c = surface.points_mm.row(face[2]);
      normal += 0.5 * (b - a).cross(c - a);
      area += 0.5 * (b - a).cross(c - a).norm();
    }
    EXPECT_NEAR(area, leak.area_mm2, 0.06 * leak.area_mm2);
    EXPECT_GT(normal.normalized().dot(leak.openings[0].normal), 0.99);
    ASSERT_GT(surface.outline.size(), 20U);
    for (const int v : surface.outline) {
      const Vec3 point = surface.points_mm.row(v);
      EXPECT_NEAR(point.head<2>().norm(), 4.5, 0.35);
      EXPECT_NEAR(point.z(), -7.0 + slope * point.x(), 0.4);
    }
  }
}

TEST(Leak, FollowsAMovedValve) {
  const Valve valve = funnel(4.0, 0.4);
  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
  motion.translate(Vec3(30.0, -20.0, 11.0))
      .rotate(Eigen::AngleAxisd(1.1, Vec3(1.0, 2.0, -0.5).normalized()));
  const Leak here = leak_of(valve), there = leak_of(moved(valve, motion));
  EXPECT_NEAR(there.area_mm2, here.area_mm2, 1e-6 * here.area_mm2);
  ASSERT_EQ(there.openings.size(), 1u);
  EXPECT_LT((there.openings[0].centroid_mm - motion * here.openings[0].centroid_mm).norm(), 1e-6);
}

TEST(Leak, OfACompetentValveIsNoneAndOfALeakingOneMovesWithItsVerticesAlone) {
  const Valve& normal = small_preset("human-normal");
  EXPECT_LT(measure_leak(normal, close_valve(normal).closed_mm).area_mm2, 1.0);
  const Valve& leaking = small_preset("human-functional-mr");
  Points closed_mm = close_valve(leaking).closed_mm;
  const double before = measure_leak(leaking, closed_mm).area_mm2;
  EXPECT_GT(before, 20.0);
  for (Index v = 0; v < closed_mm.rows(); ++v) closed_mm(v, v % 3) += v % 2 == 0 ? 0.01 : -0.01;
  EXPECT_NEAR(measure_leak(leaking, closed_mm).area_mm2, before, 0.3);
}

TEST(Leak, OfPointsThatFlewApartIsNotKnown) {
  Valve valve = disc_with_hole(12.0, 4.0);
  for (const double away_mm : {std::numeric_limits<double>::infinity(), 1e6}) {
    valve.rest_mm(300, 1) = away_mm;
    EXPECT_TRUE(std::isnan(leak_of(valve).area_mm2));
  }
}

}  // namespace
}  // namespace coapt
