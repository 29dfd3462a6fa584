#include "core/metrics/gap.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/closure/closure.h"
#include "core/metrics/orifice.h"
#include "core/presets/presets.h"
#include "tests/scenes/sheets.h"

namespace coapt {
namespace {

/// The posterior sheet lies 1 mm above the anterior one and overlaps it by 7 mm. Between x = -6 and
/// 6 it is lifted like a roof, by `ridge_mm` in the middle.
Valve flail_strip(double ridge_mm) {
  Valve valve = extruded_leaflets({{12.0, 0.0}, {12.0, -2.0}, {-2.0, -2.0}},
                                  {{-9.0, 0.0}, {-9.0, -1.0}, {5.0, -1.0}});
  for (Index f = 0; f < valve.faces.rows(); ++f)
    for (int k = 0; k < 3; ++k) {
      const int v = valve.faces(f, k);
      if (valve.segments[static_cast<std::size_t>(f)] == Segment::P2 && valve.rest_mm(v, 2) != 0.0)
        valve.rest_mm(v, 2) =
            -1.0 + ridge_mm * std::max(0.0, 1.0 - std::abs(valve.rest_mm(v, 0)) / 6.0);
    }
  return valve;
}

/// A valve that leaks behind its own prolapse.
struct Prolapse {
  Valve valve = *make_preset("human-p2-prolapse");
  Points closed_mm = close_valve(valve).closed_mm;
};

const Prolapse& prolapse() {
  static const Prolapse prolapse;
  return prolapse;
}

double area_mm2(const Valve& valve) { return gap_mm2(valve, valve.rest_mm); }

TEST(Gap, OfParallelStripsIsTheirLengthTimesWhatTheirDistanceExceedsTheThicknessBy) {
  EXPECT_NEAR(area_mm2(facing_walls(1.5)), 30.0 * 0.5, 1e-9);
  EXPECT_NEAR(area_mm2(facing_walls(4.0)), 30.0 * 3.0, 1e-9);
}

TEST(Gap, OfLeafletsThatTouchIsExactlyZero) {
  EXPECT_EQ(area_mm2(facing_walls(0.85)), 0.0);
  EXPECT_EQ(area_mm2(facing_walls(1.0)), 0.0);
}

/// Two concentric walls, 20 mm deep, over 120 degrees of arc.
Valve facing_arcs(double anterior_radius_mm, double posterior_radius_mm) {
  constexpr int kColumns = 61, kRows = 5;
  const double first = std::numbers::pi / 6.0, step = 4.0 * first / (kColumns - 1);
  Valve valve;
  std::vector<Vec3> points;
  std::vector<std::array<int, 3>> faces;
  for (const double radius_mm : {anterior_radius_mm, posterior_radius_mm})
    for (int i = 0; i < kColumns; ++i)
      for (int j = 0; j < kRows; ++j) {
        const int corner = static_cast<int>(points.size());
        points.emplace_back(-radius_mm * std::cos(first + step * i),
                            -radius_mm * std::sin(first + step * i), -5.0 * j);
        if (i + 1 == kColumns || j + 1 == kRows) continue;
        faces.push_back({corner, corner + kRows, corner + kRows + 1});
        faces.push_back({corner, corner + kRows + 1, corner + 1});
        valve.segments.insert(valve.segments.end(), 2,
                              radius_mm == anterior_radius_mm ? Segment::A2 : Segment::P2);
      }
  sheets::set_rows(valve.rest_mm, points);
  sheets::set_faces(valve, faces);
  std::vector<int> loop;
  for (int i = 0; i < kColumns; ++i) loop.push_back(i * kRows);
  for (int i = 2 * kColumns - 1; i >= kColumns; --i) loop.push_back(i * kRows);
  sheets::set_annulus(valve, loop);
  return valve;
}

TEST(Gap, OfARibbonBetweenTwoArcsIsTheSectorBetweenTheirFaces) {
  // Of 120 degrees between radii of 12.5 and 15.5 mm, whichever side is outside. The walls are
  // polygons of 60 sides, of which an outer posterior one is not reached over half of the last ones.
  const double sector = std::numbers::pi / 3.0 * (15.5 * 15.5 - 12.5 * 12.5);
  EXPECT_NEAR(area_mm2(facing_arcs(12.0, 16.0)), sector, 3e-3 * sector);
  EXPECT_NEAR(area_mm2(facing_arcs(16.0, 12.0)), sector, 3e-3 * sector);
}

TEST(Gap, OfASlitThatOpensLinearlyIsATriangle) {
  const Valve valve = facing_walls(1.0);
  Points closed = valve.rest_mm;
  for (Index f = 0; f < valve.faces.rows(); ++f)
    for (int k = 0; k < 3; ++k)
      if (valve.segments[static_cast<std::size_t>(f)] == Segment::A2)
        closed(valve.faces(f, k), 1) =
            1.0 + std::max(0.0, valve.rest_mm(valve.faces(f, k), 0)) / 3.0;
  // The anterior wall bends away from x = 0 on, to 5 mm more at x = 15, and is hypot(15, 5) long;
  // the posterior one is 15 mm long.
  EXPECT_NEAR(gap_mm2(valve, closed), 0.5 * 5.0 * 0.5 * (std::hypot(15.0, 5.0) + 15.0), 1e-9);
}

TEST(Gap, OfAFlailStripThatHidesItIsMeasuredAcrossTheOverlap) {
  const Valve valve = flail_strip(2.0);
  EXPECT_EQ(area_mm2(flail_strip(0.0)), 0.0);
  EXPECT_EQ(orifice_mm2(valve, valve.rest_mm), 0.0);
  // The roof rises by a third: below it the distance is (1 + (6 - |x|) / 3) cos(atan(1 / 3)), more
  // than 1 mm for |x| < 5.838; the width grows by sin(atan(1 / 3)) a millimetre from there, in which
  // the nearest point goes cos(atan(1 / 3)) mm. The net's nodes are 1 mm apart; in the step to x = 0
  // the nearest point leaps from one slope to the other, by (2.7, 0, 0.3).
  const double sine = std::sin(std::atan(1.0 / 3.0)), cosine = std::cos(std::atan(1.0 / 3.0));
  const double leap = (3.0 * cosine - 1.0 - 0.5 * sine) * 0.5 * (std::hypot(2.7, 0.3) - cosine);
  EXPECT_NEAR(area_mm2(valve), sine * 5.838 * 5.838 * 0.5 * (1.0 + cosine) + leap, 0.08);
}

TEST(Gap, GrowsWithoutAJumpWhenTheLeafletsPart) {
  double before = 0.0;
  for (int step = 0; step <= 60; ++step) {
    const double d = 0.7 + 0.01 * step;
    const double now = area_mm2(facing_walls(d));
    EXPECT_NEAR(now, 30.0 * std::max(0.0, d - 1.0), 1e-9);
    EXPECT_LE(now - before, 30.0 * 0.01 + 1e-9);
    before = now;
  }
}

TEST(Gap, FollowsAMovedValveAndItsMirrorImage) {
  const auto& [valve, closed_mm] = prolapse();
  const double area = gap_mm2(valve, closed_mm);
  const Eigen::Isometry3d motion = Eigen::Translation3d(3.0, -40.0, 7.0) *
                                   Eigen::AngleAxisd(0.7, Vec3(1.0, 2.0, 3.0).normalized());
  Valve closed = valve;
  closed.rest_mm = closed_mm;
  EXPECT_NEAR(gap_mm2(moved(valve, motion), moved(closed, motion).rest_mm), area, 1e-9);
  EXPECT_NEAR(gap_mm2(mirrored(valve), mirrored(closed).rest_mm), area, 1e-9);
}

TEST(Gap, CrossesWhereAnteriorTissueIsMissing) {
  Valve valve = facing_walls(1.5);
  std::vector<Index> kept;
  for (Index f = 0; f < valve.faces.rows(); ++f) {
    double x = 0.0;
    for (int k = 0; k < 3; ++k) x += valve.rest_mm(valve.faces(f, k), 0) / 3.0;
    if (valve.segments[static_cast<std::size_t>(f)] == Segment::P2 || std::abs(x) > 3.0)
      kept.push_back(f);
  }
  valve.faces = Faces(valve.faces(kept, Eigen::all));
  std::vector<Segment> segments;
  for (const Index f : kept) segments.push_back(valve.segments[static_cast<std::size_t>(f)]);
  valve.segments = segments;
  EXPECT_NEAR(area_mm2(valve), 30.0 * 0.5, 1e-9);
}

TEST(Gap, OfOneSideAloneIsInfinite) {
  Valve valve = facing_walls(1.5);
  valve.segments.assign(valve.segments.size(), Segment::P2);
  EXPECT_TRUE(std::isinf(area_mm2(valve)));
}

}  // namespace
}  // namespace coapt
