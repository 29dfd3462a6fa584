#include "core/metrics/orifice.h"

#include <gtest/gtest.h>

#include <numbers>
#include <numeric>

#include "tests/core/metrics/orifice_scene.h"
#include "tests/scenes/sheets.h"

namespace coapt {
namespace {

/// Area of a regular polygon.
double polygon_mm2(int n, double radius_mm) {
  return 0.5 * n * radius_mm * radius_mm * std::sin(2.0 * std::numbers::pi / n);
}

/// Half a pixel along the whole outline, the bound of the header.
double bound_mm2(const OrificeView& view, double perimeter_mm) {
  return 0.5 * view.mm_per_pixel * perimeter_mm;
}

TEST(Orifice, FlatDiscWithRoundHoleHasTheHolesArea) {
  for (const double radius : {1.0, 2.0, 3.0, 5.0}) {
    const Valve valve = disc_with_hole(15.0, radius);
    const OrificeView view = view_orifices(valve, valve.rest_mm, 0.0);
    ASSERT_EQ(view.orifices.size(), 1u);
    // Sampling errors along a round outline cancel: a fifth of the bound is plenty.
    EXPECT_NEAR(view.orifices[0].area_mm2, polygon_mm2(128, radius),
                0.2 * bound_mm2(view, 2.0 * std::numbers::pi * radius));
    EXPECT_LT(view.orifices[0].centroid_mm.norm(), 0.02);
  }
}

TEST(Orifice, HalfThicknessShrinksARoundHoleByThatMuch) {
  const Valve valve = disc_with_hole(15.0, 3.0);
  const OrificeView view = view_orifices(valve, valve.rest_mm, 0.5);
  EXPECT_NEAR(total_mm2(view), std::numbers::pi * 2.5 * 2.5, 0.05);
}

TEST(Orifice, HalfThicknessClosesANarrowSlitAndNotAWideOne) {
  for (const double width : {0.9, 1.1}) {
    const Valve valve =
        grid_sheet({-20.0, -8.0, 8.0, 20.0}, {-14.0, -0.5 * width, 0.5 * width, 14.0},
                   [](int i, int j) { return i == 1 && j == 1; });
    const OrificeView raw = view_orifices(valve, valve.rest_mm, 0.0);
    EXPECT_NEAR(total_mm2(raw), 16.0 * width, bound_mm2(raw, 2.0 * (16.0 + width)));
    const OrificeView grown = view_orifices(valve, valve.rest_mm, 0.5);
    if (width < 1.0) {
      EXPECT_EQ(grown.orifices.size(), 0u);
    } else {
      ASSERT_EQ(grown.orifices.size(), 1u);
      EXPECT_NEAR(total_mm2(grown), 15.0 * (width - 1.0), bound_mm2(grown, 2.0 * 15.1));
    }
  }
}

TEST(Orifice, TwoHolesAreTwoOrificesLargestFirstWithTheirPlaces) {
  // Holes of 4 x 4 mm about (-12, 6) in A1 and of 4 x 8 mm about (10, -4) in P3.
  const Valve valve = grid_sheet(lines(-20.0, 2.0, 21), lines(-14.0, 2.0, 15), [](int i, int j) {
    return (i >= 3 && i <= 4 && j >= 9 && j <= 10) || (i >= 14 && i <= 15 && j >= 3 && j <= 6);
  });
  const OrificeView view = view_orifices(valve, valve.rest_mm, 0.0);
  ASSERT_EQ(view.orifices.size(), 2u);
  EXPECT_NEAR(view.orifices[0].area_mm2, 32.0, bound_mm2(view, 24.0));
  EXPECT_NEAR(view.orifices[1].area_mm2, 16.0, bound_mm2(view, 16.0));
  EXPECT_LT((view.orifices[0].centroid_mm - Vec3(10.0, -4.0, 0.0)).norm(), view.mm_per_pixel);
  EXPECT_LT((view.orifices[1].centroid_mm - Vec3(-12.0, 6.0, 0.0)).norm(), view.mm_per_pixel);
  EXPECT_EQ(view.orifices[0].segment, Segment::P3);
  EXPECT_EQ(view.orifices[1].segment, Segment::A1);
}

TEST(Orifice, HolesThatMeetInACornerAreTwoOrifices) {
  const Valve valve = grid_sheet(lines(-20.0, 4.0, 11), lines(-14.0, 4.0, 8), [](int i, int j) {
    return (i == 4 && j == 3) || (i == 5 && j == 4);
  });
  EXPECT_EQ(view_orifices(valve, valve.rest_mm, 0.0).orifices.size(), 2u);
}

TEST(Orifice, RigidMotionChangesNothing) {
  const Valve valve = grid_sheet(lines(-20.3, 2.03, 21), lines(-14.0, 2.0, 15), [](int i, int j) {
    return (i >= 3 && i <= 4 && j >= 9 && j <= 10) || (i >= 14 && i <= 15 && j >= 3 && j <= 6);
  });
  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
  motion.translate(Vec3(100.0, -30.0, 7.0));
  motion.rotate(Eigen::AngleAxisd(2.5, Vec3(1.0, 2.0, -0.5).normalized()));
  const Valve turned = moved(valve, motion);
  const OrificeView here = view_orifices(valve, valve.rest_mm, 0.5);
  const OrificeView there = view_orifices(turned, turned.rest_mm, 0.5);
  ASSERT_EQ(here.orifices.size(), there.orifices.size());
  for (std::size_t i = 0; i < here.orifices.size(); ++i) {
    EXPECT_NEAR(here.orifices[i].area_mm2, there.orifices[i].area_mm2, 1e-6);
    EXPECT_LT((motion * here.orifices[i].centroid_mm - there.orifices[i].centroid_mm).norm(), 1e-6);
    EXPECT_EQ(here.orifices[i].segment, there.orifices[i].segment);
  }
}

TEST(Orifice, TheMirrorImageLeaksAsMuchOnTheOtherSide) {
  const Valve valve = grid_sheet(lines(-20.3, 2.03, 21), lines(-14.0, 2.0, 15), [](int i, int j) {
    return i >= 3 && i <= 4 && j >= 9 && j <= 10;
  });
  const Valve other = mirrored(valve);
  const OrificeView here = view_orifices(valve, valve.rest_mm, 0.5);
  const OrificeView there = view_orifices(other, other.rest_mm, 0.5);
  ASSERT_EQ(there.orifices.size(), 1u);
  EXPECT_NEAR(here.orifices[0].area_mm2, there.orifices[0].area_mm2, 1e-6);
  EXPECT_NEAR(here.orifices[0].centroid_mm.x(), -there.orifices[0].centroid_mm.x(), 1e-6);
  EXPECT_EQ(there.orifices[0].segment, Segment::A3);
}

TEST(Orifice, RunsAddUpToTheAreas) {
  const Valve valve = disc_with_hole(15.0, 4.0);
  const OrificeView view = view_orifices(valve, valve.rest_mm, 0.5);
  int pixels = 0;
  for (const PixelRun& run : view.runs) pixels += run.last - run.first + 1;
  EXPECT_NEAR(pixels * view.pixel_area_mm2, total_mm2(view), 1e-9);
  EXPECT_NEAR(view.pixel_area_mm2, view.mm_per_pixel * view.mm_per_pixel,
              1e-3 * view.pixel_area_mm2);
}

TEST(Orifice, PixelsAndMillimetresConvertBackAndForth) {
  const Valve valve = disc_with_hole(15.0, 4.0);
  const OrificeView view = view_orifices(valve, valve.rest_mm, 0.0);
  EXPECT_LT((from_pixels(view, to_pixels(view, {3.0, -7.0})) - Vec2(3.0, -7.0)).norm(), 1e-12);
  EXPECT_LT(to_pixels(view, {0.0, 5.0}).y(), to_pixels(view, {0.0, 0.0}).y()) << "anterior is up";
}

}  // namespace
}  // namespace coapt
