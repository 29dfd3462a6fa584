#include "core/metrics/section.h"

#include <gtest/gtest.h>

#include <numbers>

#include "tests/scenes/sheets.h"

namespace coapt {
namespace {

double length_mm(const SectionLine& line) {
  double length = 0.0;
  for (std::size_t i = 0; i + 1 < line.points_mm.size(); ++i)
    length += (line.points_mm[i + 1] - line.points_mm[i]).norm();
  return length;
}

TEST(Section, APlaneCutsAHoledDiscIntoTwoLinesFromRimToHole) {
  const Valve valve = disc_with_hole(15.0, 3.0);
  for (const double angle : {0.0, 0.1, 0.5 * std::numbers::pi}) {
    // At 0 and a right angle it passes through rows of vertices.
    const SectionPlane plane{Vec3::Zero(), Vec3(std::cos(angle), std::sin(angle), 0.0)};
    const std::vector<SectionLine> lines = cut(valve.faces, valve.rest_mm, plane);
    ASSERT_EQ(lines.size(), 2u);
    for (const SectionLine& line : lines) {
      EXPECT_EQ(line.points_mm.size(), line.faces.size() + 1);
      EXPECT_NEAR(length_mm(line), 12.0, 0.01);
    }
  }
}

TEST(Section, APlaneAcrossATubeGivesAClosedLine) {
  Valve valve = disc_with_hole(15.0, 3.0);
  for (Eigen::Index i = 0; i < valve.rest_mm.rows(); ++i)  // a cone
    valve.rest_mm(i, 2) = valve.rest_mm.row(i).head<2>().norm() - 15.0;
  const std::vector<SectionLine> lines =
      cut(valve.faces, valve.rest_mm, {Vec3(0.0, 0.0, -5.0), Vec3::UnitZ()});
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_NEAR((lines[0].points_mm.front() - lines[0].points_mm.back()).norm(), 0.0, 1e-12);
  EXPECT_NEAR(length_mm(lines[0]), 2.0 * std::numbers::pi * 10.0, 0.05);
}

TEST(Section, APlaneBesideTheLeafletsCutsNothing) {
  const Valve valve = disc_with_hole(15.0, 3.0);
  EXPECT_TRUE(cut(valve.faces, valve.rest_mm, {Vec3(20.0, 0.0, 0.0), Vec3::UnitX()}).empty());
}

TEST(Section, CoaptationPlanesStandAcrossTheLineBetweenTheCommissures) {
  const Valve valve = disc_with_hole(15.0, 3.0);
  for (const double along : {0.1, 0.2, 0.5, 0.9}) {
    const SectionPlane plane = coaptation_plane(valve, along);
    EXPECT_NEAR(plane.point_mm.x(), -15.0 + 30.0 * along, 1e-9);
    EXPECT_LT((plane.normal - Vec3::UnitX()).norm(), 1e-9);
  }
}

TEST(Section, TheMidValvePlaneHoldsBothLandmarksAndTheNormal) {
  const SectionPlane plane = mid_valve_plane(disc_with_hole(15.0, 3.0));
  EXPECT_LT((plane.normal - Vec3::UnitX()).norm(), 1e-9);
  EXPECT_NEAR(plane.point_mm.y(), 15.0, 1e-9);
}

}  // namespace
}  // namespace coapt
