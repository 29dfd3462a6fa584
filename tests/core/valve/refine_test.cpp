#include "core/valve/refine.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/valve/leaflet_coordinates.h"
#include "core/valve/subdivide.h"
#include "core/valve/validate.h"
#include "tests/scenes/small_valve.h"

namespace coapt {
namespace {

double area_mm2(const Valve& valve) {
  double sum = 0.0;
  for (Index f = 0; f < valve.faces.rows(); ++f) {
    const Vec3 a = valve.rest_mm.row(valve.faces(f, 0)), b = valve.rest_mm.row(valve.faces(f, 1)),
               c = valve.rest_mm.row(valve.faces(f, 2));
    sum += 0.5 * (b - a).cross(c - a).norm();
  }
  return sum;
}

Vec3 normal(const Valve& valve, Index face) {
  const Vec3 a = valve.rest_mm.row(valve.faces(face, 0)),
             b = valve.rest_mm.row(valve.faces(face, 1)),
             c = valve.rest_mm.row(valve.faces(face, 2));
  return (b - a).cross(c - a).normalized();
}

// small_valve() with an insertion in the middle of a face, one near a corner and one on an edge.
Valve with_insertions_inside() {
  Valve valve = small_valve();
  valve.chordae[0].segments[1].insertion = {17, {0.3, 0.3, 0.4}};
  valve.chordae[0].segments[2].insertion = {18, {0.1, 0.8, 0.1}};
  valve.chordae[1].segments[0].insertion = {9, {0.25, 0.0, 0.75}};
  return valve;
}

TEST(Subdivide, OneFaceBecomesThreeAtItsCornersAndOneInTheMiddle) {
  Faces faces(1, 3);
  faces << 0, 1, 2;
  const Subdivision fine = subdivide(faces, 3);
  // Midpoints: 3 of edge 01, 4 of 12, 5 of 20.
  Faces expected(4, 3);
  expected << 0, 3, 5, 3, 1, 4, 5, 4, 2, 4, 5, 3;
  EXPECT_EQ(fine.faces, expected);
  const std::vector<std::array<int, 2>> edges = {{0, 1}, {1, 2}, {0, 2}};
  EXPECT_EQ(fine.edges, edges);
}

TEST(Subdivide, FacesThatShareAnEdgeShareItsMidpoint) {
  Faces faces(2, 3);
  faces << 0, 1, 2, 1, 3, 2;
  const Subdivision fine = subdivide(faces, 4);
  EXPECT_EQ(fine.edges.size(), 5U);
  EXPECT_EQ(fine.faces(1, 2), fine.faces(4, 2)) << "the midpoint of 12";
  Points points(4, 3);
  points << 0, 0, 0, 4, 0, 0, 0, 2, 0, 4, 2, 6;
  EXPECT_EQ(Vec3(with_midpoints(points, fine).row(fine.faces(1, 2))), Vec3(2, 1, 0));
}

TEST(Subdivide, AnInsertionGoesToThePartThatHoldsItWithWeightsWorkedOutByHand) {
  // 0.8 a + 0.1 b + 0.1 c = 0.6 a + 0.2 (a + b) / 2 + 0.2 (a + c) / 2
  const Insertion corner = subdivided({5, {0.8, 0.1, 0.1}});
  EXPECT_EQ(corner.face, 20);
  EXPECT_NEAR(corner.weights[0], 0.6, 1e-15);
  EXPECT_NEAR(corner.weights[1], 0.2, 1e-15);
  EXPECT_NEAR(corner.weights[2], 0.2, 1e-15);
  // 0.4 a + 0.35 b + 0.25 c = 0.2 (b + c) / 2 + 0.3 (c + a) / 2 + 0.5 (a + b) / 2
  const Insertion middle = subdivided({5, {0.4, 0.35, 0.25}});
  EXPECT_EQ(middle.face, 23);
  EXPECT_NEAR(middle.weights[0], 0.2, 1e-15);
  EXPECT_NEAR(middle.weights[1], 0.3, 1e-15);
  EXPECT_NEAR(middle.weights[2], 0.5, 1e-15);
}

TEST(Subdivide, WeightsThatAddUpToOneWithinTheToleranceOfAFileAddUpToOne) {
  Insertion insertion{0, {0.3, 0.3, 0.4 + 9e-7}};
  for (int level = 0; level < 3; ++level) {
    insertion = subdivided(insertion);
    EXPECT_NEAR(insertion.weights[0] + insertion.weights[1] + insertion.weights[2], 1.0, 1e-12);
  }
}

TEST(Refine, HasFourTimesTheFacesOfTheSameSurfaceAndIsValid) {
  const Valve valve = small_valve();
  const Valve refined = *refine(valve);
  EXPECT_EQ(refined.faces.rows(), 4 * 32);
  EXPECT_EQ(refined.rest_mm.rows(), 24 + 56) << "8 columns of 3 horizontal, 2 upright, 2 diagonal";
  EXPECT_NEAR(area_mm2(refined), area_mm2(valve), 1e-9);
  for (Index face = 0; face < refined.faces.rows(); ++face)
    EXPECT_NEAR((normal(refined, face) - normal(valve, face / 4)).norm(), 0.0, 1e-12);
  EXPECT_TRUE(validate(refined).empty());
  EXPECT_TRUE(validate(*refine(refined)).empty());
}

TEST(Refine, TheAnnulusKeepsItsVerticesAndGetsOneBetweenAnyTwo) {
  Valve valve = small_valve();
  valve.annulus_mm.col(1) *= 1.25;  // under pressure it is elsewhere than at rest
  const Valve refined = *refine(valve);
  ASSERT_EQ(refined.annulus.size(), 16U);
  for (int i = 0; i < 8; ++i) {
    const int next = (i + 1) % 8;
    EXPECT_EQ(refined.annulus[2 * i], valve.annulus[i]);
    EXPECT_EQ(refined.annulus_mm.row(2 * i), valve.annulus_mm.row(i));
    const Points rest = 0.5 * (valve.rest_mm.row(i) + valve.rest_mm.row(next));
    EXPECT_EQ(refined.rest_mm.row(refined.annulus[2 * i + 1]), rest.row(0));
    const Points pressed = 0.5 * (valve.annulus_mm.row(i) + valve.annulus_mm.row(next));
    EXPECT_EQ(refined.annulus_mm.row(2 * i + 1), pressed.row(0));
  }
}

TEST(Refine, OldVerticesLandmarksHeadsAndChordaeKeepTheirIndices) {
  const Valve valve = small_valve();
  const Valve refined = *refine(valve);
  EXPECT_EQ(refined.rest_mm.topRows(24), valve.rest_mm);
  EXPECT_EQ(refined.landmarks.saddle_peak, valve.landmarks.saddle_peak);
  EXPECT_EQ(refined.landmarks.posteromedial_commissure, valve.landmarks.posteromedial_commissure);
  EXPECT_EQ(refined.heads[1].tip_mm, valve.heads[1].tip_mm);
  ASSERT_EQ(refined.chordae.size(), valve.chordae.size());
  EXPECT_EQ(refined.chordae[0].segments[2].parent, valve.chordae[0].segments[2].parent);
  EXPECT_EQ(refined.chordae[0].segments[2].rest_length_mm,
            valve.chordae[0].segments[2].rest_length_mm);
}

TEST(Refine, InsertionsAreWhereTheyWere) {
  const Valve valve = with_insertions_inside();
  const Valve once = *refine(valve), twice = *refine(once);
  for (const Valve* refined : {&once, &twice})
    for (std::size_t c = 0; c < valve.chordae.size(); ++c)
      for (std::size_t s = 0; s < valve.chordae[c].segments.size(); ++s) {
        if (!valve.chordae[c].segments[s].inserts) continue;
        const Vec3 before =
            position(valve.chordae[c].segments[s].insertion, valve.faces, valve.rest_mm);
        const Vec3 after =
            position(refined->chordae[c].segments[s].insertion, refined->faces, refined->rest_mm);
        EXPECT_NEAR((after - before).norm(), 0.0, 1e-12) << valve.chordae[c].id << " " << s;
      }
}

TEST(Refine, SegmentsAndFibresAreThoseOfTheSameTissue) {
  const Valve valve = small_valve();
  const Valve refined = *refine(valve);
  for (Index face = 0; face < refined.faces.rows(); ++face) {
    EXPECT_EQ(refined.segments[face], valve.segments[face / 4]);
    const Vec3 fibre = refined.fibre.row(face);
    EXPECT_NEAR(fibre.norm(), 1.0, 1e-12);
    EXPECT_NEAR(fibre.dot(normal(refined, face)), 0.0, 1e-12);
  }
}

TEST(Refine, LeafletCoordinatesOfTheOldVerticesHardlyMove) {
  // Harmonic functions of the same domain, solved on the finer mesh: a plan means the same on both.
  const Valve once = *refine(small_valve()), twice = *refine(once);
  const LeafletCoordinates coarse = leaflet_coordinates(once), fine = leaflet_coordinates(twice);
  for (Index i = 0; i < once.rest_mm.rows(); ++i) {
    EXPECT_NEAR(fine.height[i], coarse.height[i], 0.01) << i;
    const double apart = std::abs(fine.around[i] - coarse.around[i]);
    EXPECT_LT(std::min(apart, 1.0 - apart), 0.01) << i;
  }
}

TEST(Refine, SaysInTheProvenanceWhatItDid) {
  EXPECT_EQ(refine(small_valve())->provenance.back(),
            "refined from 32 to 128 triangles, at the midpoints of the edges");
}

TEST(Refine, RefusesAMeshThatWouldHaveTooManyFaces) {
  Valve valve = small_valve();
  for (int level = 0; level < 5; ++level) valve = *refine(valve);  // 32,768 faces
  const Expected<Valve> refused = refine(valve);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.errors().front().path, "/faces");
  EXPECT_EQ(refused.errors().front().code, ErrorCode::OutOfRange);
}

}  // namespace
}  // namespace coapt
