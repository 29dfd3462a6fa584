#include "core/metrics/coaptation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/metrics/leaflet_measure.h"
#include "core/metrics/leaflet_sides.h"
#include "core/metrics/quantile.h"
#include "tests/scenes/sheets.h"

namespace coapt {
namespace {

TEST(Coaptation, FacingWallsHaveTheDesignedHeightAndDistance) {
  const Valve valve = facing_walls(1.0);
  const Coaptation coaptation = measure_coaptation(valve, valve.rest_mm);
  for (const CoaptationSection& section : coaptation.sections) {
    // Above the shelf the wall is within 1.25 mm of it for another sqrt(1.25^2 - 1^2) = 0.75 mm.
    EXPECT_NEAR(section.height_mm, 8.75, 0.1);
    EXPECT_NEAR(section.distance_mm, 1.0, 1e-12);
    EXPECT_TRUE(section.contact);
  }
  EXPECT_NEAR(coaptation.height_min_mm, 8.75, 0.1);
  EXPECT_NEAR(coaptation.height_mean_mm, 8.75, 0.1);
  EXPECT_NEAR(coaptation.height_p10_mm, 8.75, 0.1);
  EXPECT_NEAR(coaptation.distance_max_mm, 1.0, 1e-12);
}

TEST(Coaptation, TheAreaIndexCountsWhatLiesOnTheOtherSide) {
  // Per mm of width: half of the 13 mm down to the anterior edge, half of the shelf of 9 mm, all of the
  // posterior wall of 8 mm; of 20 and 29 mm.
  const Valve near = facing_walls(1.0), far = facing_walls(1.5);
  EXPECT_NEAR(coaptation_area_index(near, near.rest_mm), (6.5 + 4.5 + 8.0) / 49.0, 1e-12);
  EXPECT_EQ(coaptation_area_index(far, far.rest_mm), 0.0);
  Points flown = near.rest_mm;
  flown(3, 1) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(std::isnan(coaptation_area_index(near, flown)));
}

TEST(Coaptation, WallsFartherApartThanTheToleranceDoNotTouch) {
  const Valve valve = facing_walls(1.5);
  const Coaptation coaptation = measure_coaptation(valve, valve.rest_mm);
  for (const CoaptationSection& section : coaptation.sections) {
    EXPECT_EQ(section.height_mm, 0.0);
    EXPECT_NEAR(section.distance_mm, 1.5, 1e-12);
    EXPECT_FALSE(section.contact);
    const auto& [anterior_mm, posterior_mm] = section.nearest_mm;
    EXPECT_NEAR((anterior_mm - posterior_mm - Vec3(0.0, 1.5, 0.0)).norm(), 0.0, 1e-9);
    EXPECT_NEAR(posterior_mm.y(), 0.0, 1e-9);
    EXPECT_NEAR(anterior_mm.x(), coaptation_plane(valve, section.along).point_mm.x(), 1e-9);
  }
}

TEST(Coaptation, AGapAtOneEndShowsInItsSectionsOnly) {
  Valve valve = facing_walls(1.0);
  Points closed = valve.rest_mm;
  for (std::size_t f = 0; f < valve.segments.size();
       ++f)  // the anterior wall bends away from x = 0 on
    if (valve.segments[f] == Segment::A2)
      for (int k = 0; k < 3; ++k) {
        const int v = valve.faces(f, k);
        closed(v, 1) = 1.0 + std::max(0.0, valve.rest_mm(v, 0)) / 3.0;
      }
  const Coaptation coaptation = measure_coaptation(valve, closed);
  EXPECT_NEAR(coaptation.sections[0].height_mm, 8.75, 0.1);
  EXPECT_NEAR(coaptation.sections[4].distance_mm, 1.0, 1e-9);
  EXPECT_FALSE(coaptation.sections[8].contact);
  EXPECT_NEAR(coaptation.sections[8].along, 0.9, 1e-12);
  // x = 12: wall at y = 5, but the posterior wall, parallel to x, is 5 mm off.
  EXPECT_NEAR(coaptation.distance_max_mm, 5.0, 1e-9);
  EXPECT_EQ(coaptation.height_min_mm, 0.0);
}

TEST(Coaptation, FacesOfTheCommissuresBelongToTheSideOnWhichTheyLie) {
  Valve valve = disc_with_hole(15.0, 3.0);
  for (Segment& segment : valve.segments)
    if (segment == Segment::A1 || segment == Segment::P1) segment = Segment::AC;
  const std::vector<Leaflet> sides = leaflet_sides(valve);
  for (std::size_t f = 0; f < sides.size(); ++f) {
    double y = 0.0;
    for (int k = 0; k < 3; ++k) y += valve.rest_mm(valve.faces(f, k), 1);
    EXPECT_EQ(sides[f], y > 0.0 ? Leaflet::Anterior : Leaflet::Posterior);
  }
}

TEST(Tenting, LeafletsThatTouchTentDownToTheirContact) {
  // Straight leaflets from the annulus at y = 10 and y = -10 to walls 1 mm apart, 6 mm down.
  const Valve valve = extruded_leaflets({{10.0, 0.0}, {0.5, -6.0}, {0.5, -10.0}},
                                        {{-10.0, 0.0}, {-0.5, -6.0}, {-0.5, -10.0}});
  const Tenting tenting = measure_tenting(valve, valve.rest_mm, {1.0 + 1e-9, 0.02});
  EXPECT_TRUE(tenting.contact);
  EXPECT_NEAR(tenting.height_mm, 6.0, 0.02);
  EXPECT_NEAR(tenting.area_mm2, 0.5 * (20.0 + 1.0) * 6.0, 0.05);
  EXPECT_LT((tenting.coaptation_point_mm - Vec3(0.0, 0.0, -6.0)).norm(), 0.02);
  EXPECT_NEAR(tenting.anterior_mm, std::hypot(9.5, 6.0), 0.02);
  EXPECT_NEAR(tenting.posterior_mm, std::hypot(9.5, 6.0), 0.02);
}

TEST(Tenting, WithoutContactTheHigherFreeEdgeCounts) {
  const Valve valve = extruded_leaflets({{10.0, 0.0}, {2.0, -6.0}}, {{-10.0, 0.0}, {-2.0, -5.0}});
  const Tenting tenting = measure_tenting(valve, valve.rest_mm);
  EXPECT_FALSE(tenting.contact);
  EXPECT_NEAR(tenting.height_mm, 5.0, 1e-9);
  EXPECT_NEAR(tenting.anterior_mm, 10.0, 1e-9);
  EXPECT_NEAR(tenting.area_mm2, 24.0 + 22.0 + 20.0, 1e-9);
}

TEST(Tenting, BillowingAboveTheAnnularLineIsNegative) {
  const Valve valve = extruded_leaflets({{10.0, 0.0}, {2.0, 3.0}}, {{-10.0, 0.0}, {-2.0, 3.0}});
  const Tenting tenting = measure_tenting(valve, valve.rest_mm);
  EXPECT_NEAR(tenting.height_mm, -3.0, 1e-9);
  EXPECT_NEAR(tenting.area_mm2, -(12.0 + 12.0 + 12.0), 1e-9);
}

TEST(Quantile, InterpolatesBetweenOrderStatistics) {
  EXPECT_DOUBLE_EQ(quantile({9.0, 1.0, 5.0}, 0.0), 1.0);
  EXPECT_DOUBLE_EQ(quantile({9.0, 1.0, 5.0}, 0.25), 3.0);
  EXPECT_DOUBLE_EQ(quantile({9.0, 1.0, 5.0}, 1.0), 9.0);
  EXPECT_EQ(quantile({}, 0.5), 0.0);
}

}  // namespace
}  // namespace coapt
