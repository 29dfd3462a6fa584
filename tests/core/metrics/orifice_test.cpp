#include "core/metrics/orifice.h"

#include <gtest/gtest.h>

#include <numbers>

#include "core/metrics/leak_estimate.h"
#include "tests/scenes/sheets.h"

namespace coapt {
namespace {

constexpr double kPixel_mm = 40.0 / 750.0;  // of the scenes' annulus in the thesis's image, or less

/// Coordinates of a grid's lines.
std::vector<double> lines(double first, double step, int count) {
  std::vector<double> values;
  for (int i = 0; i < count; ++i) values.push_back(first + step * i);
  return values;
}

/// Area of a regular polygon.
double polygon_mm2(int n, double radius_mm) {
  return 0.5 * n * radius_mm * radius_mm * std::sin(2.0 * std::numbers::pi / n);
}

/// Half a pixel along the whole outline, the bound of the header.
double bound_mm2(double perimeter_mm) { return 0.5 * kPixel_mm * perimeter_mm; }

/// Holes of 4 x 4 mm about (-12, 6) and of 4 x 8 mm about (10, -4).
Valve two_holes() {
  return grid_sheet(lines(-20.0, 2.0, 21), lines(-14.0, 2.0, 15), [](int i, int j) {
    return (i >= 3 && i <= 4 && j >= 9 && j <= 10) || (i >= 14 && i <= 15 && j >= 3 && j <= 6);
  });
}

TEST(Orifice, FlatDiscWithRoundHoleHasTheHolesArea) {
  for (const double radius : {1.0, 2.0, 3.0, 5.0}) {
    const Valve valve = disc_with_hole(15.0, radius);
    // Sampling errors along a round outline cancel: a fifth of the bound is plenty.
    EXPECT_NEAR(orifice_mm2(valve, valve.rest_mm, 0.0), polygon_mm2(128, radius),
                0.2 * bound_mm2(2.0 * std::numbers::pi * radius));
  }
}

TEST(Orifice, HalfThicknessShrinksARoundHoleByThatMuch) {
  const Valve valve = disc_with_hole(15.0, 3.0);
  EXPECT_NEAR(orifice_mm2(valve, valve.rest_mm), std::numbers::pi * 2.5 * 2.5, 0.05);
}

TEST(Orifice, HalfThicknessClosesANarrowSlitAndNotAWideOne) {
  for (const double width : {0.9, 1.1}) {
    const Valve valve =
        grid_sheet({-20.0, -8.0, 8.0, 20.0}, {-14.0, -0.5 * width, 0.5 * width, 14.0},
                   [](int i, int j) { return i == 1 && j == 1; });
    EXPECT_NEAR(orifice_mm2(valve, valve.rest_mm, 0.0), 16.0 * width,
                bound_mm2(2.0 * (16.0 + width)));
    if (width < 1.0)
      EXPECT_EQ(orifice_mm2(valve, valve.rest_mm), 0.0);
    else
      EXPECT_NEAR(orifice_mm2(valve, valve.rest_mm), 15.0 * (width - 1.0), bound_mm2(2.0 * 15.1));
  }
}

TEST(Orifice, OfTwoHolesIsTheirSumHoweverTheValveLies) {
  const Valve valve = two_holes();
  const double area = orifice_mm2(valve, valve.rest_mm, 0.0);
  EXPECT_NEAR(area, 48.0, bound_mm2(40.0));
  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
  motion.translate(Vec3(100.0, -30.0, 7.0));
  motion.rotate(Eigen::AngleAxisd(2.5, Vec3(1.0, 2.0, -0.5).normalized()));
  const Valve turned = moved(valve, motion), other = mirrored(valve);
  EXPECT_NEAR(orifice_mm2(turned, turned.rest_mm, 0.0), area, bound_mm2(40.0));
  EXPECT_NEAR(orifice_mm2(other, other.rest_mm, 0.0), area, bound_mm2(40.0));
}

TEST(LeakEstimate, IsTheLargerOfOrificeAndGap) {
  const Valve holes = two_holes(), walls = facing_walls(1.5);
  // Its image is coarser: half a pixel of 0.21 mm along both outlines at most.
  EXPECT_NEAR(estimate_leak_mm2(holes, holes.rest_mm), orifice_mm2(holes, holes.rest_mm), 3.8);
  EXPECT_NEAR(estimate_leak_mm2(walls, walls.rest_mm), 30.0 * 0.5, 1e-9);
  Points flown = walls.rest_mm;
  flown(3, 1) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(std::isnan(estimate_leak_mm2(walls, flown)));
}

}  // namespace
}  // namespace coapt
