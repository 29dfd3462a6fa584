#include "core/metrics/exact_orifice.h"

#include <gtest/gtest.h>

#include <numbers>
#include <numeric>

#include "tests/core/metrics/orifice_scene.h"
#include "tests/scenes/sheets.h"

namespace coapt {
namespace {

constexpr double kPi = std::numbers::pi;

/// Of 40 x 28 mm with a hole of x mm by y mm in the middle.
Valve sheet_with_hole(double x, double y) {
  return grid_sheet({-20.0, -0.5 * x, 0.5 * x, 20.0}, {-14.0, -0.5 * y, 0.5 * y, 14.0},
                    [](int i, int j) { return i == 1 && j == 1; });
}

/// An annulus of 40 x 20 mm round leaflets given as triangles of points in its plane.
Valve leaflets(const std::vector<std::array<Vec3, 3>>& triangles) {
  Valve valve;
  std::vector<Vec3> points = {
      {-20.0, -10.0, 0.0}, {20.0, -10.0, 0.0}, {20.0, 10.0, 0.0}, {-20.0, 10.0, 0.0}};
  std::vector<std::array<int, 3>> faces;
  for (const std::array<Vec3, 3>& triangle : triangles) {
    const int first = static_cast<int>(points.size());
    points.insert(points.end(), triangle.begin(), triangle.end());
    faces.push_back({first, first + 1, first + 2});
  }
  sheets::set_rows(valve.rest_mm, points);
  sheets::set_faces(valve, faces);
  sheets::set_annulus(valve, {0, 1, 2, 3});
  sheets::set_segments(valve, 20.0);
  return valve;
}

/// Two triangles: the rectangle from (x0, y0) to (x1, y1) at height z.
std::vector<std::array<Vec3, 3>> flap(double x0, double y0, double x1, double y1, double z) {
  return {{Vec3(x0, y0, z), Vec3(x1, y0, z), Vec3(x1, y1, z)},
          {Vec3(x0, y0, z), Vec3(x1, y1, z), Vec3(x0, y1, z)}};
}

std::vector<std::array<Vec3, 3>> joined(std::vector<std::array<Vec3, 3>> all,
                                        const std::vector<std::array<Vec3, 3>>& more) {
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

ExactOrifice at_rest(const Valve& valve, double half_thickness_mm) {
  return exact_orifice(valve, valve.rest_mm, half_thickness_mm);
}

TEST(ExactOrifice, DiscWithRoundHoleHasTheHolesArea) {
  for (const double radius : {1.0, 3.0, 5.0}) {
    const ExactOrifice exact = at_rest(disc_with_hole(15.0, radius), 0.0);
    EXPECT_NEAR(exact.area_mm2, 64.0 * radius * radius * std::sin(2.0 * kPi / 128), 1e-5);
    ASSERT_EQ(exact.orifices.size(), 1u);
    EXPECT_LT(exact.orifices[0].centroid_mm.norm(), 1e-5);
  }
}

TEST(ExactOrifice, OutlinesGoRoundTheOrificeAndTheIslandsInIt) {
  // A hole of 20 x 14 mm with a free sheet of 6 x 4 mm in it.
  const Valve valve =
      leaflets(joined(joined(joined(flap(-20, -10, -10, 10, 0), flap(10, -10, 20, 10, 0)),
                             joined(flap(-10, -10, 10, -7, 0), flap(-10, 7, 10, 10, 0))),
                      flap(-3, -2, 3, 2, 0)));
  const std::vector<OrificeOutline> outlines = orifice_outlines(valve, valve.rest_mm, 0.0);
  ASSERT_EQ(outlines.size(), 1u);
  EXPECT_NEAR(outlines[0].area_mm2, 20.0 * 14.0 - 6.0 * 4.0, 1e-6);
  ASSERT_EQ(outlines[0].contours_mm.size(), 2u);
  const Points& outer = outlines[0].contours_mm[0];
  EXPECT_EQ(outer.rows(), 4);
  EXPECT_NEAR(outer.col(0).cwiseAbs().minCoeff(), 10.0, 1e-5);
  EXPECT_NEAR(outer.col(1).cwiseAbs().minCoeff(), 7.0, 1e-5);
  const Points& island = outlines[0].contours_mm[1];
  EXPECT_EQ(island.rows(), 4);
  EXPECT_NEAR(island.col(0).cwiseAbs().maxCoeff(), 3.0, 1e-5);
}

TEST(ExactOrifice, OutlinesAreAsHighAsTheTissueBesideThem) {
  // A slit of 20 x 2 mm between sheets 3 mm above and 1 mm below the plane, closed at its ends.
  const Valve valve =
      leaflets(joined(joined(flap(-20, 1, 20, 10, 3), flap(-20, -10, 20, -1, -1)),
                      joined(flap(-20, -10, -10, 10, 0), flap(10, -10, 20, 10, 0))));
  const std::vector<OrificeOutline> outlines = orifice_outlines(valve, valve.rest_mm, 0.25);
  ASSERT_EQ(outlines.size(), 1u);
  ASSERT_EQ(outlines[0].contours_mm.size(), 1u);
  const Points& line = outlines[0].contours_mm[0];
  ASSERT_EQ(line.rows(), 4);
  for (Eigen::Index i = 0; i < 4; ++i) {
    EXPECT_NEAR(std::abs(line(i, 1)), 0.75, 1e-5) << "seen from above it is the orifice";
    EXPECT_NEAR(line(i, 2), line(i, 1) > 0.0 ? 3.0 : -1.0, 1e-5);
  }
}

TEST(ExactOrifice, HalfThicknessMovesTheSidesOfAConvexHoleInwards) {
  // Each side of the 128-gon moves by r towards the middle: its inscribed circle shrinks by r.
  const double inscribed = 3.0 * std::cos(kPi / 128) - 0.5;
  const ExactOrifice round = at_rest(disc_with_hole(15.0, 3.0), 0.5);
  EXPECT_NEAR(round.area_mm2, 128.0 * inscribed * inscribed * std::tan(kPi / 128), 1e-5);
  const ExactOrifice square = at_rest(sheet_with_hole(4.0, 4.0), 0.5);
  EXPECT_NEAR(square.area_raw_mm2, 16.0, 1e-5);
  EXPECT_NEAR(square.area_mm2, 9.0, 1e-5);
  EXPECT_EQ(at_rest(sheet_with_hole(4.0, 0.9), 0.5).area_mm2, 0.0);
  EXPECT_NEAR(at_rest(sheet_with_hole(4.0, 1.1), 0.5).area_mm2, 0.3, 1e-5);
}

TEST(ExactOrifice, AFreeSquareGrowsByItsPerimeterAndADisc) {
  const Valve valve = leaflets(flap(-3.0, -2.0, 3.0, 2.0, 1.0));
  const ExactOrifice exact = at_rest(valve, 0.5);
  EXPECT_NEAR(exact.area_raw_mm2, 800.0 - 24.0, 1e-4);
  EXPECT_NEAR(exact.area_mm2, 800.0 - (24.0 + 20.0 * 0.5 + kPi * 0.25), 4e-4);
  ASSERT_EQ(exact.orifices.size(), 1u) << "an island parts nothing";
  EXPECT_LT(exact.orifices[0].centroid_mm.norm(), 1e-5);
}

TEST(ExactOrifice, OverlappingFlapsCoverWhatTheyShareOnce) {
  // From the left to x = 2 and from the right to x = -1, the second one turned over and lower.
  std::vector<std::array<Vec3, 3>> right = flap(-1.0, -10.0, 20.0, 4.0, -3.0);
  for (std::array<Vec3, 3>& triangle : right) std::swap(triangle[0], triangle[1]);
  const Valve valve = leaflets(joined(flap(-20.0, -10.0, 2.0, 6.0, 0.0), right));
  const double open_mm2 = 800.0 - 22.0 * 16.0 - 21.0 * 14.0 + 3.0 * 14.0;
  EXPECT_NEAR(at_rest(valve, 0.0).area_mm2, open_mm2, 1e-4);
  // Open: 22 x 4 mm beside 18 x 6 mm. Their lower sides move up, the step's outer corner is
  // rounded.
  EXPECT_NEAR(at_rest(valve, 0.5).area_mm2, 22.5 * 3.5 + 17.5 * 5.5 + (0.25 - 0.25 * kPi * 0.25),
              1e-4);
}

TEST(ExactOrifice, TwoHolesAreTwoOrificesWithTheirPlaces) {
  const Valve valve = grid_sheet(lines(-20.0, 2.0, 21), lines(-14.0, 2.0, 15), [](int i, int j) {
    return (i >= 3 && i <= 4 && j >= 9 && j <= 10) || (i >= 14 && i <= 15 && j >= 3 && j <= 6);
  });
  const ExactOrifice exact = at_rest(valve, 0.0);
  ASSERT_EQ(exact.orifices.size(), 2u);
  EXPECT_NEAR(exact.orifices[0].area_mm2, 32.0, 1e-4);
  EXPECT_NEAR(exact.orifices[1].area_mm2, 16.0, 1e-4);
  EXPECT_LT((exact.orifices[0].centroid_mm - Vec3(10.0, -4.0, 0.0)).norm(), 1e-5);
  EXPECT_LT((exact.orifices[1].centroid_mm - Vec3(-12.0, 6.0, 0.0)).norm(), 1e-5);
  EXPECT_EQ(exact.orifices[0].segment, Segment::P3);
  EXPECT_EQ(exact.orifices[1].segment, Segment::A1);
}

TEST(ExactOrifice, HolesThatMeetInACornerAreTwoOrifices) {
  const Valve valve = grid_sheet(lines(-20.0, 4.0, 11), lines(-14.0, 4.0, 8), [](int i, int j) {
    return (i == 4 && j == 3) || (i == 5 && j == 4);
  });
  const ExactOrifice exact = at_rest(valve, 0.0);
  ASSERT_EQ(exact.orifices.size(), 2u);
  EXPECT_NEAR(exact.orifices[0].area_mm2, 16.0, 1e-4);
}

TEST(ExactOrifice, RigidMotionAndTheMirrorImageChangeNothing) {
  const Valve valve = grid_sheet(lines(-20.3, 2.03, 21), lines(-14.0, 2.0, 15), [](int i, int j) {
    return (i >= 3 && i <= 4 && j >= 9 && j <= 10) || (i >= 14 && i <= 15 && j >= 3 && j <= 6);
  });
  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
  motion.translate(Vec3(100.0, -30.0, 7.0));
  motion.rotate(Eigen::AngleAxisd(2.5, Vec3(1.0, 2.0, -0.5).normalized()));
  const ExactOrifice here = at_rest(valve, 0.5);
  const ExactOrifice there = at_rest(moved(valve, motion), 0.5);
  const ExactOrifice mirror = at_rest(mirrored(valve), 0.5);
  ASSERT_EQ(here.orifices.size(), 2u);
  ASSERT_EQ(there.orifices.size(), 2u);
  ASSERT_EQ(mirror.orifices.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_NEAR(here.orifices[i].area_mm2, there.orifices[i].area_mm2, 1e-4);
    EXPECT_NEAR(here.orifices[i].area_mm2, mirror.orifices[i].area_mm2, 1e-4);
    EXPECT_LT((motion * here.orifices[i].centroid_mm - there.orifices[i].centroid_mm).norm(), 1e-5);
    EXPECT_EQ(here.orifices[i].segment, there.orifices[i].segment);
  }
}

TEST(ExactOrifice, ASheetSeenEdgeOnCoversItsThicknessAndNothingWithoutOne) {
  // Two upright faces: 6 mm along x together, 3 mm high.
  const Valve valve =
      leaflets({{Vec3(-3.0, 0.0, 0.0), Vec3(3.0, 0.0, 0.0), Vec3(3.0, 0.0, -3.0)},
                {Vec3(-3.0, 0.0, 0.0), Vec3(3.0, 0.0, -3.0), Vec3(-3.0, 0.0, -3.0)}});
  const ExactOrifice exact = at_rest(valve, 0.5);
  EXPECT_NEAR(exact.area_raw_mm2, 800.0, 1e-4);
  EXPECT_NEAR(exact.area_mm2, 800.0 - (6.0 + kPi * 0.25), 4e-4);
}

TEST(ExactOrifice, AFaceShrunkToAPointGrowsToADisc) {
  const Valve valve = leaflets({{Vec3(3.0, 2.0, 0.0), Vec3(3.0, 2.0, 0.0), Vec3(3.0, 2.0, 0.0)}});
  EXPECT_NEAR(at_rest(valve, 0.5).area_mm2, 800.0 - kPi * 0.25, 4e-4);
}

TEST(ExactOrifice, FacesWithoutAreaAndFacesFarAwayDoNoHarm) {
  const Valve valve =
      leaflets(joined(flap(-20.0, -10.0, 20.0, 0.0, 0.0),
                      {{Vec3(1.0, -5.0, 0.0), Vec3(1.0, -5.0, 0.0), Vec3(1.0, -5.0, 0.0)},
                       {Vec3(-5.0, -5.0, 0.0), Vec3(0.0, -5.0, 0.0), Vec3(5.0, -5.0, 0.0)},
                       {Vec3(0.0, -20.0, 0.0), Vec3(1e9, -20.0, 0.0), Vec3(0.0, -1e300, 0.0)}}));
  EXPECT_NEAR(at_rest(valve, 0.0).area_mm2, 400.0, 1e-4);
  EXPECT_NEAR(at_rest(valve, 0.5).area_mm2, 40.0 * 9.5, 1e-4);
}

TEST(ExactOrifice, AnnulusPointsInLineOrThereTwiceChangeNothing) {
  Valve valve = leaflets(flap(-3.0, -2.0, 3.0, 2.0, 0.0));
  Points loop(8, 3);
  loop << -20, -10, 0, 0, -10, 0, 20, -10, 0, 20, -10, 0, 20, 10, 0, 0, 10, 0, -20, 10, 0, -20, 0,
      0;
  valve.annulus = {0, 1, 1, 1, 2, 3, 3, 3};  // only landmarks are looked up
  valve.annulus_mm = loop;
  Projection projection = project_valve(valve, valve.rest_mm, AnnulusFrame{});
  EXPECT_NEAR(exact_orifice(valve, projection, 0.0).area_mm2, 776.0, 1e-4);
}

TEST(ExactOrifice, InsideIsWhateverAnAnnulusThatCrossesItselfWindsRound) {
  const Valve valve = leaflets(flap(-100.0, -100.0, -99.0, -99.0, 0.0));
  Projection projection = project_valve(valve, valve.rest_mm, AnnulusFrame{});
  projection.annulus = {{-10.0, -5.0}, {10.0, 5.0}, {10.0, -5.0}, {-10.0, 5.0}};  // a bow tie
  const ExactOrifice bow_tie = exact_orifice(valve, projection, 0.0);
  EXPECT_NEAR(bow_tie.area_mm2, 100.0, 1e-4);
  EXPECT_EQ(bow_tie.orifices.size(), 2u);
  projection.annulus = {{0, 0}, {8, 0}, {8, 4}, {2, 4}, {2, -2}, {4, -2}, {4, 6}, {0, 6}};
  // 4 x 6, 4 x 4 beyond it, 2 x 2 below, the loop inside wound round twice.
  EXPECT_NEAR(exact_orifice(valve, projection, 0.0).area_mm2, 24.0 + 16.0 + 4.0, 1e-4);
}

TEST(ExactOrifice, TheMeanIsTakenOverTheEndStates) {
  const Valve valve = disc_with_hole(15.0, 3.0);
  ClosureResult closure = closed_at_rest(valve);
  Points narrower = valve.rest_mm;  // the hole's rim, the last ring, drawn in to 2 mm
  narrower.bottomRows(128) *= 2.0 / 3.0;
  closure.samples_mm = {narrower, valve.rest_mm};
  const OrificeMeasure measure = measure_orifice(valve, closure);
  EXPECT_NEAR(measure.area_mean_mm2, 0.5 * std::numbers::pi * (2.5 * 2.5 + 1.5 * 1.5), 0.1);
  EXPECT_NEAR(measure.area_raw_mm2, std::numbers::pi * 9.0, 0.1);
  closure.samples_mm.clear();
  EXPECT_EQ(measure_orifice(valve, closure).area_mean_mm2, measure.area_mm2);
}

}  // namespace
}  // namespace coapt
