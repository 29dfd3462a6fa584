#include "core/opened/funnel.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/metrics/exact_orifice.h"
#include "core/valve/leaflet_coordinates.h"
#include "tests/scenes/small_preset.h"

namespace coapt {
namespace {

constexpr double kPi = std::numbers::pi;

/// A preset's leaflets laid on a surface of revolution; `place` gives (distance from the axis, z) by angle and height.
template <class Place>
std::pair<Valve, Points> laid(const Place& place) {
  Valve valve = shared_preset("human-normal", 1300);
  const LeafletCoordinates coordinates = leaflet_coordinates(valve);
  Points points = valve.rest_mm;
  for (Eigen::Index v = 0; v < points.rows(); ++v) {
    const double angle = 2.0 * kPi * coordinates.around[static_cast<std::size_t>(v)];
    const Eigen::Vector2d at = place(angle, coordinates.height[static_cast<std::size_t>(v)]);
    points.row(v) << at.x() * std::cos(angle), at.x() * std::sin(angle), at.y();
  }
  for (std::size_t i = 0; i < valve.annulus.size(); ++i)
    valve.annulus_mm.row(static_cast<Eigen::Index>(i)) = points.row(valve.annulus[i]);
  valve.tissue.thickness_mm = 1.0;
  return {valve, points};
}

TEST(FreeArea, ALineAcrossASquareTakesItsThickness) {
  const std::vector<Vec2> square = {{0, 0}, {10, 0}, {10, 10}, {0, 10}};
  EXPECT_NEAR(free_area_mm2(square, {{{0, 5}, {10, 5}}}, 0.5), 90.0, 1e-3);
  EXPECT_NEAR(free_area_mm2(square, {}, 0.5), 100.0, 1e-9);
  EXPECT_NEAR(free_area_mm2(square, {{{0, 5}, {10, 5}}}, 0.0), 100.0, 1e-9);
}

TEST(Funnel, AConeIsNarrowestAtItsEnd) {
  const auto [valve, points] = laid(
      [](double, double height) { return Eigen::Vector2d(18.0 - 6.0 * height, -15.0 * height); });
  const FunnelPassage passage = narrowest_passage(valve, points);
  // Radius 12 at the end; the last plane lies up to 0.5 mm above it; half a millimetre of tissue.
  EXPECT_NEAR(passage.area_mm2, kPi * 11.6 * 11.6, 0.04 * kPi * 11.6 * 11.6);
  EXPECT_NEAR(passage.depth_mm, 14.75, 0.3);
  EXPECT_NEAR(passage.axis.z(), -1.0, 1e-3);
  for (const Vec3& point : passage.outline_mm) {  // of the mid-surface, on the cone
    EXPECT_NEAR(point.z(), -passage.depth_mm, 0.05);
    EXPECT_NEAR(point.head<2>().norm(), 18.0 + 0.4 * point.z(), 0.15);
  }
  EXPECT_GT(passage.outline_mm.size(), 30u);
}

TEST(Funnel, TheOutlineFollowsFreeEdgesThatLieAboveTheNarrowestPlane) {
  const auto length = [](double angle) { return 13.5 + 1.5 * std::cos(2.0 * angle); };
  const auto [valve, points] = laid([&](double angle, double height) {
    return Eigen::Vector2d(18.0 - 8.0 * height, -length(angle) * height);
  });
  const FunnelPassage passage = narrowest_passage(valve, points);
  ASSERT_GT(passage.depth_mm, 12.5);  // the free edges are at 12 to 15
  double highest_mm = -100.0;
  for (std::size_t i = 0; i < passage.outline_mm.size(); ++i) {
    const Vec3 &point = passage.outline_mm[i],
               &next = passage.outline_mm[(i + 1) % passage.outline_mm.size()];
    const double radius = 18.0 + 8.0 * point.z() / length(std::atan2(point.y(), point.x()));
    EXPECT_NEAR(point.head<2>().norm(), radius, 0.25);
    EXPECT_LT((next - point).norm(), 4.0);
    highest_mm = std::max(highest_mm, point.z());
  }
  EXPECT_NEAR(highest_mm, -12.0, 0.1);
}

TEST(Funnel, AnHourglassIsNarrowestAtItsWaist) {
  const auto [valve, points] = laid([](double, double height) {
    return Eigen::Vector2d(10.0 + 6.0 * std::abs(2.0 * height - 1.0), -16.0 * height);
  });
  const FunnelPassage passage = narrowest_passage(valve, points);
  // Vertices lie up to a quarter of a row off the waist, at some stations more than at others; half a millimetre of tissue.
  const double waist_mm = points.leftCols(2).rowwise().norm().minCoeff();
  EXPECT_GT(passage.area_mm2, kPi * std::pow(waist_mm - 0.5, 2.0));
  EXPECT_LT(passage.area_mm2, kPi * std::pow(waist_mm, 2.0));
  EXPECT_NEAR(passage.depth_mm, 8.0, 1.5);
}

TEST(Funnel, AFunnelThatWidensIsNarrowestAtTheAnnulus) {
  const auto [valve, points] = laid(
      [](double, double height) { return Eigen::Vector2d(12.0 + 6.0 * height, -15.0 * height); });
  const FunnelPassage passage = narrowest_passage(valve, points);
  EXPECT_NEAR(passage.area_mm2, kPi * 11.5 * 11.5, 0.02 * kPi * 11.5 * 11.5);
  EXPECT_EQ(passage.depth_mm, 0.0);
  EXPECT_EQ(passage.outline_mm.size(), valve.annulus.size());
}

TEST(Funnel, WhatFlowsOutBetweenTheLeafletsCounts) {
  // A tube of 12 mm, 15 mm long in front and behind, 8 mm at the sides: below that blood leaves sideways, too, so that nothing is
  // gained by looking further down.
  const auto [valve, points] = laid([](double angle, double height) {
    const double length = 11.5 + 3.5 * std::cos(2.0 * angle);
    return Eigen::Vector2d(12.0, -length * height);
  });
  EXPECT_NEAR(narrowest_passage(valve, points).area_mm2, kPi * 11.5 * 11.5,
              0.02 * kPi * 11.5 * 11.5);
}

}  // namespace
}  // namespace coapt
