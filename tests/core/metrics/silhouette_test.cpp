#include "core/metrics/silhouette.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/scenes/sheets.h"

namespace coapt {
namespace {

FlatTissue seen_from_above(const Valve& valve) {
  return silhouette(valve, project_valve(valve, valve.rest_mm, AnnulusFrame{}));
}

TEST(Silhouette, OfADiscWithAHoleIsItsTwoRims) {
  const FlatTissue tissue = seen_from_above(disc_with_hole(15.0, 3.0, 128));
  ASSERT_EQ(tissue.outlines_mm.size(), 2u);
  EXPECT_TRUE(tissue.lines_mm.empty());
  double area_mm2 = 0.0;
  for (const std::vector<Vec2>& loop : tissue.outlines_mm) {
    EXPECT_EQ(loop.size(), 128u);
    area_mm2 += polygon_area(loop);
  }
  EXPECT_NEAR(area_mm2, 64.0 * (225.0 - 9.0) * std::sin(2.0 * std::numbers::pi / 128), 1e-4);
}

TEST(Silhouette, FacesSeenFromBelowCoverAsThoseSeenFromAbove) {
  Valve valve = disc_with_hole(15.0, 3.0);
  valve.faces.col(1).swap(valve.faces.col(2));
  double area_mm2 = 0.0;
  for (const std::vector<Vec2>& loop : seen_from_above(valve).outlines_mm)
    area_mm2 += polygon_area(loop);
  EXPECT_NEAR(area_mm2, 64.0 * (225.0 - 9.0) * std::sin(2.0 * std::numbers::pi / 128), 1e-4);
}

TEST(Silhouette, AFaceSeenEdgeOnIsItsLongestEdge) {
  Valve valve;
  sheets::set_rows(valve.rest_mm, {{0, 0, 0}, {3, 0, 1}, {3, 4, -2}, {1.5, 2, 7}});
  sheets::set_faces(valve, {{0, 2, 3}});
  valve.annulus = {0, 1, 2};
  valve.annulus_mm = valve.rest_mm.topRows(3);
  const FlatTissue tissue = seen_from_above(valve);
  EXPECT_TRUE(tissue.outlines_mm.empty());
  ASSERT_EQ(tissue.lines_mm.size(), 1u);
  EXPECT_NEAR((tissue.lines_mm[0][1] - tissue.lines_mm[0][0]).norm(), 5.0, 1e-5);
}

}  // namespace
}  // namespace coapt
