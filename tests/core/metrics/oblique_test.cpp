#include "core/metrics/oblique.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/metrics/exact_orifice.h"
#include "tests/scenes/sheets.h"

namespace coapt {
namespace {

TEST(Oblique, TiltedAxesLeanToTheirAzimuthAndStayRightHanded) {
  const AnnulusFrame plane;
  EXPECT_LT((tilted(plane, 90.0, 0.0).normal - plane.x).norm(), 1e-12);
  EXPECT_LT((tilted(plane, 90.0, 90.0).normal - plane.y).norm(), 1e-12);
  const AnnulusFrame view = tilted(plane, 33.0, 205.0);
  EXPECT_NEAR(view.normal.dot(plane.normal), std::cos(33.0 * std::numbers::pi / 180.0), 1e-12);
  EXPECT_LT((view.x.cross(view.y) - view.normal).norm(), 1e-12);
  EXPECT_LT((tilted(plane, 0.0, 70.0).x - plane.x).norm(), 1e-12);
}

TEST(Oblique, AHoleInAFlatSheetIsWidestStraightOn) {
  const Valve valve = grid_sheet({-20.0, -2.0, 2.0, 20.0}, {-14.0, -1.5, 1.5, 14.0},
                                 [](int i, int j) { return i == 1 && j == 1; });
  const ObliqueOrifice straight = oblique_orifice(valve, valve.rest_mm, 0.0);
  EXPECT_NEAR(straight.area_mm2, 12.0, 1e-4);
  EXPECT_EQ(straight.tilt_deg, 0.0);
}

/// A prolapse: the posterior leaflet ends at y = 2 mm, 6 mm above the anterior one, which ends at
/// -2.
Valve overlapping_leaflets() {
  return extruded_leaflets({{10.0, 0.0}, {-2.0, 0.0}}, {{-10.0, 6.0}, {2.0, 6.0}});
}

/// Between their edges, 30 mm long, along a direction that leans anteriorly by `angle` from z.
double passage_mm2(double angle, double half_thickness_mm) {
  const double width = 6.0 * std::sin(angle) - 4.0 * std::cos(angle) - 2.0 * half_thickness_mm;
  return 30.0 * std::max(0.0, width);
}

TEST(Oblique, TheWidthBetweenOverlappingLeafletsFollowsFromTheDirection) {
  const Valve valve = overlapping_leaflets();
  for (const double tilt_deg : {0.0, 20.0, 30.0, 40.0, 50.0, 60.0})
    for (const double half_thickness_mm : {0.0, 0.5}) {
      const Projection view =
          project_valve(valve, valve.rest_mm, tilted(AnnulusFrame{}, tilt_deg, 90.0));
      EXPECT_NEAR(exact_orifice(valve, view, half_thickness_mm).area_mm2,
                  passage_mm2(tilt_deg * std::numbers::pi / 180.0, half_thickness_mm), 1e-3)
          << tilt_deg;
    }
}

TEST(Oblique, ThePassageBesideAPosteriorProlapseLeansAnteriorly) {
  const Valve valve = overlapping_leaflets();
  const AnnulusFrame plane = annulus_frame(valve, AnnulusAxis::Commissures);
  EXPECT_EQ(exact_orifice(valve, valve.rest_mm, 0.5).area_mm2, 0.0) << "hidden from the atrium";
  const ObliqueOrifice widest = oblique_orifice(valve, valve.rest_mm, 0.5);
  EXPECT_EQ(widest.azimuth_deg, 90.0);
  const Vec3 direction = tilted(plane, widest.tilt_deg, widest.azimuth_deg).normal;
  EXPECT_NEAR(widest.area_mm2, passage_mm2(std::atan2(direction.y(), direction.z()), 0.5), 1e-3);
}

TEST(Oblique, ACoveredAnnulusIsClosedFromEverywhere) {
  const Valve valve =
      grid_sheet({-20.0, 0.0, 20.0}, {-14.0, 0.0, 14.0}, [](int, int) { return false; });
  EXPECT_NEAR(oblique_orifice(valve, valve.rest_mm, 0.0).area_mm2, 0.0, 1e-4);
  EXPECT_EQ(oblique_orifice(valve, valve.rest_mm, 0.5).area_mm2, 0.0);
}

}  // namespace
}  // namespace coapt
