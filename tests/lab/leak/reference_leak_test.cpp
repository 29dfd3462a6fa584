#include "lab/leak/reference_leak.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "core/closure/closure.h"
#include "tests/lab/leak/exact_shapes.h"
#include "tests/scenes/small_preset.h"

namespace coapt {
namespace {

constexpr double kPi = std::numbers::pi;

/// To half a per cent: the hole's area less what half the sheet's thickness takes all round.
void expect_exactly(const LeakSurface& sheet, double area_mm2) {
  const ReferenceLeak leak = reference_leak(sheet);
  EXPECT_NEAR(leak.area_mm2, area_mm2, 0.005 * area_mm2);
  EXPECT_LE(leak.dual_mm2, leak.primal_mm2);
  EXPECT_NEAR(leak.dual_mm2, leak.primal_mm2, 0.003 * area_mm2);
  ASSERT_EQ(leak.openings.size(), 1U);
  EXPECT_NEAR(leak.openings.front().area_mm2, leak.area_mm2, 0.05);  // specks
}

TEST(ReferenceLeak, RoundHoleLeaksItsAreaLessHalfTheThickness) {
  expect_exactly(funnel(14.0, circle(4.0, -0.5)), kPi * 3.5 * 3.5);
  expect_exactly(funnel(12.0, circle(2.0, -0.5)), kPi * 1.5 * 1.5);
}

TEST(ReferenceLeak, SlitLeaksItsAreaLessHalfTheThickness) {
  expect_exactly(funnel(14.0, slit(20.0, 2.2, -6.0)), 19.0 * 1.2);
  expect_exactly(funnel(14.0, slit(20.0, 3.0, -6.0)), 19.0 * 2.0);
}

TEST(ReferenceLeak, ConeLeaksAtItsTip) {
  expect_exactly(funnel(14.0, circle(5.0, -9.0)), kPi * 4.5 * 4.5);
}

TEST(ReferenceLeak, TiltedConeLeaksInThePlaneOfItsRim) {
  // The rim is an ellipse of half axes 5 and 5 sqrt(1 + 0.3^2 + 0.2^2); its length by Ramanujan.
  const double longer = 5.0 * std::sqrt(1.13), h = std::pow((longer - 5.0) / (longer + 5.0), 2.0);
  const double length = kPi * (longer + 5.0) * (1.0 + 3.0 * h / (10.0 + std::sqrt(4.0 - 3.0 * h)));
  const LeakSurface sheet = sheared(funnel(14.0, circle(5.0, -6.0)), {0.3, 0.2});
  expect_exactly(sheet, kPi * 5.0 * longer - 0.5 * length + 0.25 * kPi);
  const Vec3 normal = reference_leak(sheet, {.finest_mm = 0.5}).openings.front().normal;
  EXPECT_NEAR(normal.dot(Vec3(-0.3, -0.2, 1.0).normalized()), 1.0, 0.001);
}

TEST(ReferenceLeak, WithoutAHoleThereIsNone) {
  const ReferenceLeak leak = reference_leak(funnel(14.0, circle(0.2, -4.0)), {.finest_mm = 0.5});
  EXPECT_NEAR(leak.area_mm2, 0.0, 0.02);
  EXPECT_TRUE(leak.openings.empty());
}

TEST(ReferenceLeak, OfTwoHolesEachIsAnOpening) {
  // Two slits side by side in one sheet: a wide one is bridged by a bar in its middle.
  LeakSurface sheet = funnel(14.0, slit(20.0, 3.0, -1.0));
  const auto bar = [&](double turn) {
    const Index first = sheet.points_mm.rows();
    sheet.points_mm.conservativeResize(first + 3, Eigen::NoChange);
    const Vec3 middle(0.137, -0.211, -0.907);
    for (int k = 0; k < 3; ++k) {
      const double along = k == 0 ? -1.0 : k == 1 ? 1.0 : 0.0, across = k == 2 ? -turn : turn;
      sheet.points_mm.row(first + k) =
          middle + Eigen::AngleAxisd(0.4, Vec3::UnitZ()) * Vec3(along, 2.0 * across, 0.0);
    }
    sheet.faces.conservativeResize(sheet.faces.rows() + 1, Eigen::NoChange);
    sheet.faces.bottomRows<1>() << static_cast<int>(first), static_cast<int>(first + 1),
        static_cast<int>(first + 2);
  };
  bar(1.0);
  bar(-1.0);
  const ReferenceLeak leak = reference_leak(sheet);
  ASSERT_EQ(leak.openings.size(), 2U);
  EXPECT_NEAR(leak.openings[0].area_mm2, leak.openings[1].area_mm2, 0.03 * leak.area_mm2);
  EXPECT_GT((leak.openings[0].centroid_mm - leak.openings[1].centroid_mm).norm(), 8.0);
}

TEST(ReferenceLeak, FinerVoxelsLoseNothingInTheBandOfCoarseOnes) {
  // A band too narrow lost a fifth.
  const Valve& valve = small_preset("human-functional-mr");
  const ReferenceLeak leak = reference_leak(leak_surface(valve, close_valve(valve).closed_mm));
  ASSERT_EQ(leak.levels.size(), 3U);
  EXPECT_GT(leak.levels[2].primal_mm2, 0.94 * leak.levels[1].primal_mm2);
}

TEST(ReferenceLeak, ABandThatTheCutTouchesIsWidened) {
  const LeakSurface sheet = funnel(14.0, circle(5.0, -9.0));
  const ReferenceLeak wide = reference_leak(sheet, {.finest_mm = 0.5});
  const ReferenceLeak narrow = reference_leak(sheet, {.finest_mm = 0.5, .band_mm = 0.5});
  EXPECT_EQ(wide.levels.back().widened, 0);
  EXPECT_NEAR(narrow.area_mm2, wide.area_mm2, 0.005 * wide.area_mm2);
}

}  // namespace
}  // namespace coapt
