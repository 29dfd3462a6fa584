// Answers worked out by hand, for both ways to find openings.
#include "core/metrics/openings.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/metrics/openings_clipper.h"
#include "core/metrics/openings_sweep.h"

namespace coapt {
namespace {

using Loop = std::vector<Vec2>;

Loop rectangle(double x0, double y0, double x1, double y1) {
  return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

Loop reversed(const Loop& loop) { return {loop.rbegin(), loop.rend()}; }

Loop turned(Loop loop, double angle) {
  for (Vec2& corner : loop) corner = Eigen::Rotation2Dd(angle) * corner;
  return loop;
}

Loop regular_polygon(int n, double radius) {
  Loop loop;
  for (int i = 0; i < n; ++i)
    loop.push_back(turned({{radius, 0.0}}, 2.0 * std::numbers::pi * i / n).front());
  return loop;
}

Loop closed(Loop loop) {
  loop.push_back(loop.front());
  return loop;
}

Vec2 centroid_mm(const Opening& opening) { return opening.moment_mm3 / opening.area_mm2; }

class OpeningsBy : public testing::TestWithParam<decltype(&openings_of)> {
 protected:
  std::vector<Opening> bare(const Loop& outline, const FlatTissue& tissue) const {
    return GetParam()(outline, tissue, 0.0).bare.value();
  }
  std::vector<Opening> grown(const Loop& outline, const FlatTissue& tissue,
                             double radius_mm) const {
    return GetParam()(outline, tissue, radius_mm).grown.value();
  }
};

INSTANTIATE_TEST_SUITE_P(Each, OpeningsBy, testing::Values(&clipped_openings, &swept_openings),
                         [](const auto& test) {
                           return test.param == &clipped_openings ? "Clipping" : "Sweeping";
                         });

TEST_P(OpeningsBy, WithoutTissueTheOutlineIsOpen) {
  const std::vector<Opening> found = bare(rectangle(1, 2, 7, 6), {});
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(found[0].area_mm2, 24.0, 1e-4);
  EXPECT_LT((centroid_mm(found[0]) - Vec2(4.0, 4.0)).norm(), 1e-4);
  ASSERT_EQ(found[0].contours_mm.size(), 1u);
  EXPECT_NEAR(polygon_area(found[0].contours_mm[0]), 24.0, 1e-2);
  EXPECT_TRUE(bare({}, {}).empty());
  EXPECT_TRUE(bare({{1, 2}, {3, 4}}, {}).empty());
}

TEST_P(OpeningsBy, ASquareHoleInAPlateIsOpenAndDrawnInByTheRadius) {
  const Loop outline = rectangle(-20, -14, 20, 14);
  const FlatTissue plate{{outline, reversed(rectangle(1, -2, 5, 2))}, {}};
  const std::vector<Opening> raw = bare(outline, plate);
  ASSERT_EQ(raw.size(), 1u);
  EXPECT_NEAR(raw[0].area_mm2, 16.0, 1e-4);
  EXPECT_LT((centroid_mm(raw[0]) - Vec2(3.0, 0.0)).norm(), 1e-4);
  const std::vector<Opening> open = grown(outline, plate, 0.5);
  ASSERT_EQ(open.size(), 1u);
  EXPECT_NEAR(open[0].area_mm2, 9.0, 1e-4);
  EXPECT_TRUE(grown(outline, plate, 2.01).empty());
}

TEST_P(OpeningsBy, ARoundGapInAGrownLineIsDrawnInByTheRadius) {
  // A polygon about a circle of radius 4.5 mm less the radius.
  const Loop circle = regular_polygon(180, 4.5 / std::cos(std::numbers::pi / 180));
  const std::vector<Opening> found = grown(circle, {{}, {closed(circle)}}, 0.5);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(found[0].area_mm2, 180.0 * 16.0 * std::tan(std::numbers::pi / 180), 2e-4);
  EXPECT_LT(found[0].moment_mm3.norm(), 1e-3);
  ASSERT_EQ(found[0].contours_mm.size(), 1u);
  for (const Vec2& corner : found[0].contours_mm[0]) EXPECT_NEAR(corner.norm(), 4.0, 5e-3);
}

TEST_P(OpeningsBy, DiscsInTheCornersOfASquareLeaveAFourPointedStar) {
  const Loop square = rectangle(-1, -1, 1, 1);
  FlatTissue corners;
  for (const Vec2& corner : square) corners.lines_mm.push_back({corner, corner});
  const std::vector<Opening> found = grown(square, corners, 0.8);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(found[0].area_mm2, 4.0 - std::numbers::pi * 0.64, 4e-4);
  const std::vector<Opening> narrow = grown(square, corners, 1.0);
  ASSERT_FALSE(narrow.empty());
  EXPECT_NEAR(narrow[0].area_mm2, 4.0 - std::numbers::pi, 5e-4);
}

TEST_P(OpeningsBy, AnIslandIsAContourOfItsOwn) {
  const Loop outline = rectangle(-10, -10, 10, 10);
  const FlatTissue island{{rectangle(2, 3, 6, 5)}, {}};
  const std::vector<Opening> found = bare(outline, island);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(found[0].area_mm2, 400.0 - 8.0, 1e-3);
  EXPECT_LT((found[0].moment_mm3 + 8.0 * Vec2(4.0, 4.0)).norm(), 1e-2);
  ASSERT_EQ(found[0].contours_mm.size(), 2u);
  EXPECT_NEAR(polygon_area(found[0].contours_mm[0]), 400.0, 1e-2);
  EXPECT_NEAR(polygon_area(found[0].contours_mm[1]), -8.0, 1e-2);
  const std::vector<Opening> open = grown(outline, island, 0.5);
  ASSERT_EQ(open.size(), 1u);
  EXPECT_NEAR(open[0].area_mm2, 400.0 - (8.0 + 12.0 * 0.5 + std::numbers::pi * 0.25), 1e-3);
  EXPECT_NEAR(polygon_area(open[0].contours_mm.back()),
              -(8.0 + 12.0 * 0.5 + std::numbers::pi * 0.25), 2e-2);
}

TEST_P(OpeningsBy, ARingOfTissuePartsWhatItSurroundsFromTheRest) {
  const Loop outline = rectangle(-10, -10, 10, 10);
  const FlatTissue ring{{rectangle(-6, -6, 6, 6), reversed(rectangle(-4, -4, 4, 4))}, {}};
  const std::vector<Opening> found = bare(outline, ring);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_NEAR(found[0].area_mm2, 400.0 - 144.0, 1e-3);
  EXPECT_EQ(found[0].contours_mm.size(), 2u);
  EXPECT_NEAR(found[1].area_mm2, 64.0, 1e-3);
  EXPECT_EQ(found[1].contours_mm.size(), 1u);
}

TEST_P(OpeningsBy, TheRadiusSealsANarrowSlitAndNotAWideOne) {
  const Loop outline = rectangle(-20, -10, 20, 10);
  for (const double width : {0.9, 1.1})
    for (const double angle : {0.0, 0.3, 0.5 * std::numbers::pi}) {
      const FlatTissue plate{{turned(rectangle(-40, -30, 40, 30), angle),
                              turned(reversed(rectangle(-8, -0.5 * width, 8, 0.5 * width)), angle)},
                             {}};
      const std::vector<Opening> found = grown(outline, plate, 0.5);
      EXPECT_EQ(found.size(), width < 1.0 ? 0u : 1u);
      if (width < 1.0) continue;
      EXPECT_NEAR(found[0].area_mm2, 15.0 * 0.1, 1e-3);
    }
}

TEST_P(OpeningsBy, LeavesThatOverlapCoverWhatTheyShareOnce) {
  const Loop outline = rectangle(0, 0, 10, 10);
  const FlatTissue leaves{{rectangle(-1, -1, 6, 11), rectangle(4, -1, 11, 7)}, {}};
  EXPECT_NEAR(total_mm2(bare(outline, leaves)), 4.0 * 3.0, 1e-4);
  // Sides move by half a millimetre, and the corner that points into the opening is hidden.
  EXPECT_NEAR(total_mm2(grown(outline, leaves, 0.5)), 3.5 * 2.5, 1e-4);
}

TEST_P(OpeningsBy, ALineAcrossPartsAnOpeningLargestFirst) {
  const std::vector<Opening> found =
      grown(rectangle(0, 0, 10, 10), {{}, {{{-1, 2}, {5, 2}, {11, 2}}}}, 0.5);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_NEAR(found[0].area_mm2, 75.0, 1e-3);
  EXPECT_LT((centroid_mm(found[0]) - Vec2(5.0, 6.25)).norm(), 1e-4);
  EXPECT_NEAR(found[1].area_mm2, 15.0, 1e-3);
  EXPECT_LT((centroid_mm(found[1]) - Vec2(5.0, 0.75)).norm(), 1e-4);
}

TEST_P(OpeningsBy, HolesThatMeetInACornerAreTwoOpenings) {
  const Loop outline = rectangle(-10, -10, 10, 10);
  const FlatTissue plate{
      {outline, reversed(rectangle(-4, -4, 0, 0)), reversed(rectangle(0, 0, 3, 3))}, {}};
  const std::vector<Opening> found = bare(outline, plate);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_NEAR(found[0].area_mm2, 16.0, 1e-3);
  EXPECT_NEAR(found[1].area_mm2, 9.0, 1e-3);
}

TEST_P(OpeningsBy, InsideIsWhateverTheOutlineWindsRound) {
  const std::vector<Opening> bow_tie = bare({{-10, -5}, {10, 5}, {10, -5}, {-10, 5}}, {});
  ASSERT_EQ(bow_tie.size(), 2u);
  EXPECT_NEAR(total_mm2(bow_tie), 100.0, 1e-3);
  const std::vector<Opening> twice =
      bare({{0, 0}, {8, 0}, {8, 4}, {2, 4}, {2, -2}, {4, -2}, {4, 6}, {0, 6}}, {});
  EXPECT_NEAR(total_mm2(twice), 24.0 + 16.0 + 4.0, 1e-3);
}

TEST_P(OpeningsBy, ASlitOfAThousandthOfAMillimetreIsOneOpening) {
  // Down and up again in steps of 1 mm, both sides with their corners at the same x.
  Loop below = {{10, -20}, {-10, -20}}, above = {{10, 20}, {-10, 20}};
  for (int i = -10; i <= 10; ++i) {
    below.emplace_back(i, 0.05 * i * i);
    above.emplace_back(i, 0.05 * i * i + 0.001);
  }
  const std::vector<Opening> found =
      bare(rectangle(-10, -20, 10, 20), {{below, reversed(above)}, {}});
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(found[0].area_mm2, 20.0 * 0.001, 1e-4);
}

TEST_P(OpeningsBy, TurningThePlaneChangesNothing) {
  const Loop outline = rectangle(-10, -10, 10, 10), hole = regular_polygon(17, 4.0);
  const FlatTissue plate{{outline, reversed(hole)}, {{{-1, -3}, {1, -1}, {-1, 2}}}};
  const double raw_mm2 = polygon_area(hole), open_mm2 = total_mm2(grown(outline, plate, 0.4));
  for (const double angle : {0.1, 0.7, 1.3, 2.0, 4.1}) {
    FlatTissue there;
    for (const Loop& loop : plate.outlines_mm) there.outlines_mm.push_back(turned(loop, angle));
    for (const Loop& line : plate.lines_mm) there.lines_mm.push_back(turned(line, angle));
    EXPECT_NEAR(total_mm2(bare(turned(outline, angle), there)), raw_mm2, 5e-4);
    EXPECT_NEAR(total_mm2(grown(turned(outline, angle), there, 0.4)), open_mm2, 5e-4);
  }
}

TEST(Openings, NoSumIsKnownOfAUnionThatFailed) { EXPECT_TRUE(std::isnan(total_mm2(std::nullopt))); }

}  // namespace
}  // namespace coapt
