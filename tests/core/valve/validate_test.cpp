#include "core/valve/validate.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "core/valve/parametric.h"
#include "tests/scenes/small_valve.h"

namespace coapt {
namespace {

using Found = std::vector<std::pair<ErrorCode, std::string>>;
using enum ErrorCode;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

// What validate() finds in the small valve after `spoil`.
Found found(const std::function<void(Valve&)>& spoil) {
  Valve valve = small_valve();
  spoil(valve);
  Found list;
  for (const Error& error : validate(valve)) list.emplace_back(error.code, error.path);
  return list;
}

std::string first_message(const std::function<void(Valve&)>& spoil) {
  Valve valve = small_valve();
  spoil(valve);
  const Errors errors = validate(valve);
  return errors.empty() ? "" : errors.front().message;
}

bool contains(const Found& list, ErrorCode code, const std::string& path) {
  return std::find(list.begin(), list.end(), std::pair(code, path)) != list.end();
}

// Appends a face with a fibre along its first edge.
void add_face(Valve& valve, int a, int b, int c) {
  valve.faces.conservativeResize(valve.faces.rows() + 1, 3);
  valve.faces.bottomRows(1) << a, b, c;
  valve.segments.push_back(Segment::A2);
  valve.fibre.conservativeResize(valve.faces.rows(), 3);
  valve.fibre.bottomRows(1) = (valve.rest_mm.row(b) - valve.rest_mm.row(a)).normalized();
}

void add_vertex(Valve& valve, double x, double y, double z) {
  valve.rest_mm.conservativeResize(valve.rest_mm.rows() + 1, 3);
  valve.rest_mm.bottomRows(1) << x, y, z;
}

void remove_faces(Valve& valve, std::vector<int> faces) {
  std::sort(faces.rbegin(), faces.rend());
  for (const int face : faces) {
    const auto after = valve.faces.rows() - face - 1;
    valve.faces.middleRows(face, after) = valve.faces.bottomRows(after).eval();
    valve.fibre.middleRows(face, after) = valve.fibre.bottomRows(after).eval();
    valve.faces.conservativeResize(valve.faces.rows() - 1, 3);
    valve.fibre.conservativeResize(valve.fibre.rows() - 1, 3);
    valve.segments.erase(valve.segments.begin() + face);
  }
}

void flip(Valve& valve, int face) { std::swap(valve.faces(face, 0), valve.faces(face, 1)); }

void reverse_annulus(Valve& valve) {
  std::reverse(valve.annulus.begin(), valve.annulus.end());
  valve.annulus_mm = valve.annulus_mm.colwise().reverse().eval();
}

TEST(Validate, TheSmallValveHasNoProblem) {
  EXPECT_EQ(found([](Valve&) {}), Found{});
}

TEST(Validate, HeadsThatNoChordaUsesAreFine) {
  EXPECT_EQ(found([](Valve& v) { v.chordae.clear(); }), Found{});
}

TEST(Validate, NumbersOutsideTheirRangesAreNamed) {
  EXPECT_EQ(found([](Valve& v) { v.pressure_kpa = kNan; }), (Found{{OutOfRange, "/pressure_kpa"}}));
  EXPECT_EQ(found([](Valve& v) { v.pressure_kpa = 101.0; }),
            (Found{{OutOfRange, "/pressure_kpa"}}));
  EXPECT_EQ(first_message([](Valve& v) { v.pressure_kpa = -1.0; }),
            "is -1, must be from 0 to 100 kPa");
  EXPECT_EQ(found([](Valve& v) { v.rest_mm(9, 1) = kInfinity; }),
            (Found{{OutOfRange, "/vertices_mm/9/1"}}));
  EXPECT_EQ(found([](Valve& v) { v.heads[1].tip_mm.x() = kNan; }),
            (Found{{OutOfRange, "/papillary_heads/1/tip_mm/0"}}));
}

TEST(Validate, EveryTissueFieldHasARange) {
  const auto spoil = [](Valve& v) {
    v.tissue = {kNan, kNan, kNan, kNan, kNan, kNan, kNan, kNan, TissueReference::InVivo,
                kNan, kNan, kNan, kNan};
  };
  EXPECT_EQ(found(spoil), (Found{{OutOfRange, "/tissue/density_g_per_mm3"},
                                 {OutOfRange, "/tissue/thickness_mm"},
                                 {OutOfRange, "/tissue/circumferential_pre_kpa"},
                                 {OutOfRange, "/tissue/circumferential_post_kpa"},
                                 {OutOfRange, "/tissue/circumferential_transition"},
                                 {OutOfRange, "/tissue/radial_pre_kpa"},
                                 {OutOfRange, "/tissue/radial_post_kpa"},
                                 {OutOfRange, "/tissue/radial_transition"},
                                 {OutOfRange, "/tissue/chordae_kpa"},
                                 {OutOfRange, "/tissue/circumferential_prestretch"},
                                 {OutOfRange, "/tissue/radial_prestretch"},
                                 {OutOfRange, "/tissue/bending_n_mm"}}));
}

TEST(Validate, TissueTooThickForItsMeshIsNamedWithTheMostThatWouldDo) {
  ParametricValve fine;
  fine.triangles = 40000;
  Valve valve = *make_parametric_valve(fine);
  EXPECT_TRUE(validate(valve).empty());
  valve.tissue.thickness_mm = 8.0;
  const Errors errors = validate(valve);
  ASSERT_EQ(errors.size(), 1u);
  EXPECT_EQ(errors.front().path, "/tissue/thickness_mm");
  EXPECT_NE(errors.front().message.find("must be at most"), std::string::npos);
}

TEST(Validate, AnEmptyValveGetsOneProblemForEachPartThatIsMissing) {
  EXPECT_EQ(found([](Valve& v) { v = Valve{}; }), (Found{{OutOfRange, "/vertices_mm"},
                                                         {OutOfRange, "/faces"},
                                                         {OutOfRange, "/annulus/vertices"},
                                                         {OutOfRange, "/papillary_heads"}}));
}

TEST(ValidateMesh, VertexIndicesOutOfRangeAreNamedByCorner) {
  EXPECT_EQ(found([](Valve& v) { v.faces(3, 1) = 24; }), (Found{{BadReference, "/faces/3/1"}}));
  EXPECT_EQ(found([](Valve& v) { v.faces(3, 2) = -1; }), (Found{{BadReference, "/faces/3/2"}}));
}

TEST(ValidateMesh, AThirdFaceAtAnEdgeIsNotASurface) {
  EXPECT_EQ(found([](Valve& v) { add_face(v, 1, 8, 20); }), (Found{{BadTopology, "/faces/32"}}));
}

TEST(ValidateMesh, AFaceWoundAgainstItsNeighboursIsFlipped) {
  EXPECT_EQ(found([](Valve& v) { flip(v, 5); }), (Found{{BadGeometry, "/faces/5"}}));
  // Face 0 starts the walk over the mesh, and still is the one in the minority.
  EXPECT_EQ(found([](Valve& v) { flip(v, 0); }), (Found{{BadGeometry, "/faces/0"}}));
}

TEST(ValidateMesh, AMeshFlippedAsAWholeIsOneProblem) {
  const auto flip_all = [](Valve& v) {
    for (int face = 0; face < v.faces.rows(); ++face) flip(v, face);
  };
  EXPECT_EQ(found(flip_all), (Found{{BadGeometry, "/faces"}}));
}

TEST(ValidateMesh, AMoebiusStripIsRefused) {
  const auto twist = [](Valve& v) {
    remove_faces(v, {28, 29, 30, 31});  // column 7, rejoined with its two rows exchanged
    add_face(v, 7, 16, 15);
    add_face(v, 16, 8, 15);
    add_face(v, 15, 8, 23);
    add_face(v, 8, 0, 23);
  };
  EXPECT_TRUE(contains(found(twist), BadTopology, "/faces"));
}

TEST(ValidateMesh, ASecondSheetIsRefused) {
  const auto add_sheet = [](Valve& v) {
    add_vertex(v, 0.0, 0.0, -5.0);
    add_vertex(v, 1.0, 0.0, -5.0);
    add_vertex(v, 0.0, 1.0, -5.0);
    add_face(v, 24, 25, 26);
  };
  EXPECT_EQ(found(add_sheet), (Found{{BadTopology, "/faces/32"}}));
}

TEST(ValidateMesh, AVertexWithoutFaceIsRefused) {
  EXPECT_EQ(found([](Valve& v) { add_vertex(v, 0.0, 0.0, -5.0); }),
            (Found{{BadTopology, "/vertices_mm/24"}}));
}

TEST(ValidateMesh, BowTiesAreRefused) {
  // Without faces 14 (11, 12, 19) and 17 (5, 13, 12) two fans meet in each of vertices 5, 12
  // and 19.
  const auto cut = [](Valve& v) {
    v.chordae.clear();
    remove_faces(v, {14, 17});
  };
  EXPECT_EQ(found(cut), (Found{{BadTopology, "/vertices_mm/5"},
                               {BadTopology, "/vertices_mm/12"},
                               {BadTopology, "/vertices_mm/19"}}));
}

TEST(ValidateMesh, DegenerateFacesAreRefused) {
  const auto collapse = [](Valve& v) {
    v.rest_mm.row(9) = 0.5 * (v.rest_mm.row(1) + v.rest_mm.row(8));  // face 1 is 1, 9, 8
  };
  EXPECT_TRUE(contains(found(collapse), BadGeometry, "/faces/1"));
  EXPECT_EQ(found([](Valve& v) { v.faces(2, 1) = v.faces(2, 0); }),
            (Found{{BadGeometry, "/faces/2"}}));
}

TEST(ValidateMesh, EdgesAreNotTooShort) {
  // The shortest ones lie on the free edge, beside +-x; vertices 16 and 17 of face 3 are the first.
  const double edge = std::hypot(9.0 - 9.0 * std::sqrt(0.5), 7.0 * std::sqrt(0.5));
  const auto shrink = [edge](double shortest_mm) {
    return [scale = shortest_mm / edge](Valve& v) { v.rest_mm *= scale; };
  };
  EXPECT_EQ(found(shrink(0.0201)), (Found{{BadGeometry, "/vertices_mm"}}));
  EXPECT_EQ(found(shrink(0.0199)),
            (Found{{BadGeometry, "/faces/3"}, {BadGeometry, "/vertices_mm"}}));
  EXPECT_EQ(
      first_message(shrink(0.0199)),
      "has an edge of 0.0199 mm, the shortest of 4 faces with edges below 0.02 mm; edges must "
      "be 0.02 mm or longer");
}

TEST(ValidateMesh, AreNotTooManyFaces) {
  const auto fill = [](int faces) {
    return [faces](Valve& v) { v.faces = v.faces.row(0).replicate(faces, 1).eval(); };
  };
  EXPECT_FALSE(contains(found(fill(100000)), OutOfRange, "/faces"));
  EXPECT_TRUE(contains(found(fill(100001)), OutOfRange, "/faces"));
}

TEST(ValidateMesh, EachLeafletHasItsThreeSegments) {
  const auto paint = [](Segment from, Segment to) {
    return [from, to](Valve& v) { std::replace(v.segments.begin(), v.segments.end(), from, to); };
  };
  EXPECT_EQ(found(paint(Segment::A2, Segment::A1)), (Found{{BadTopology, "/segments"}}));
  const auto all_p2 = [](Valve& v) {
    std::fill(v.segments.begin(), v.segments.end(), Segment::P2);
  };
  EXPECT_EQ(found(all_p2), (Found{{BadTopology, "/segments"}}));
  EXPECT_EQ(first_message(all_p2).find("has no face of A1 A2 A3 P1 P3;"), 0u);
  EXPECT_EQ(found([](Valve& v) { v.segments[0] = Segment::PC; }), Found{});
}

TEST(ValidateMesh, FibresAreUnitVectorsInTheirFaces) {
  EXPECT_EQ(found([](Valve& v) { v.fibre.row(4) *= 1.01; }), (Found{{OutOfRange, "/fibre/4"}}));
  EXPECT_EQ(found([](Valve& v) { v.fibre(4, 0) = kNan; }), (Found{{OutOfRange, "/fibre/4"}}));
  EXPECT_EQ(found([](Valve& v) { v.fibre.row(4) << 0.0, 1.0, 0.0; }),
            (Found{{BadGeometry, "/fibre/4"}}));
  EXPECT_EQ(found([](Valve& v) { v.segments.pop_back(); }), (Found{{OutOfRange, "/segments"}}));
  EXPECT_EQ(found([](Valve& v) { v.fibre.conservativeResize(31, 3); }),
            (Found{{OutOfRange, "/fibre"}}));
}

TEST(ValidateAnnulus, TheAnnulusIsALoopOfDistinctVertices) {
  EXPECT_EQ(found([](Valve& v) { v.annulus[3] = 24; }),
            (Found{{BadReference, "/annulus/vertices/3"}}));
  EXPECT_EQ(found([](Valve& v) { v.annulus[3] = 2; }),
            (Found{{BadTopology, "/annulus/vertices/3"}}));
  EXPECT_EQ(found([](Valve& v) { v.annulus_mm.conservativeResize(7, 3); }),
            (Found{{OutOfRange, "/annulus/positions_mm"}}));
}

TEST(ValidateAnnulus, TheAnnulusFollowsTheBoundary) {
  const auto skip = [](Valve& v) {  // from 4 to 6, no edge
    v.annulus.erase(v.annulus.begin() + 5);
    v.annulus_mm.row(5) = v.annulus_mm.row(6).eval();
    v.annulus_mm.row(6) = v.annulus_mm.row(7).eval();
    v.annulus_mm.conservativeResize(7, 3);
  };
  EXPECT_EQ(found(skip), (Found{{BadTopology, "/annulus/vertices/4"}}));
}

TEST(ValidateAnnulus, TheAnnulusRunsCounterClockwise) {
  EXPECT_EQ(found(reverse_annulus), (Found{{BadGeometry, "/annulus/vertices"}}));
  const auto mirror_indices = [](Valve& v) {
    reverse_annulus(v);
    for (int face = 0; face < v.faces.rows(); ++face) flip(v, face);
  };
  EXPECT_EQ(found(mirror_indices),
            (Found{{BadGeometry, "/annulus/vertices"}, {BadGeometry, "/faces"}}));
}

TEST(ValidateAnnulus, AClosedBagHasNoFreeEdge) {
  const auto close = [](Valve& v) {
    add_vertex(v, 0.0, 0.0, -20.0);
    for (int i = 0; i < 8; ++i) add_face(v, 16 + i, 16 + (i + 1) % 8, 24);
  };
  EXPECT_EQ(found(close), (Found{{BadTopology, "/faces"}}));
}

TEST(ValidateAnnulus, MetresAreRecognised) {
  const auto in_metres = [](Valve& v) {
    v.rest_mm *= 1e-3;
    v.annulus_mm *= 1e-3;
  };
  EXPECT_EQ(found(in_metres), (Found{{BadGeometry, "/faces/3"},
                                     {BadGeometry, "/annulus/positions_mm"},
                                     {BadGeometry, "/vertices_mm"}}));
  Valve valve = small_valve();
  in_metres(valve);
  EXPECT_NE(validate(valve)[1].message.find("looks like metres"), std::string::npos);
  const auto in_tenths = [](Valve& v) { v.annulus_mm *= 10.0; };
  EXPECT_EQ(found(in_tenths), (Found{{BadGeometry, "/annulus/positions_mm"}}));
  EXPECT_EQ(first_message(in_tenths).find("looks like metres"), std::string::npos);
  const auto in_one_point = [](Valve& v) { v.annulus_mm *= 0.0; };
  EXPECT_NE(first_message(in_one_point).find("all points are the same"), std::string::npos);
}

TEST(ValidateAnnulus, TheFrameIsCentredOnTheAnnulus) {
  const auto shift = [](Valve& v) { v.annulus_mm.col(1).array() += 15.1; };
  EXPECT_EQ(found(shift), (Found{{BadGeometry, "/annulus/positions_mm"}}));
}

TEST(ValidateAnnulus, TheFrameIsTurnedToTheCommissures) {
  const auto turn = [](Valve& v) { v.annulus_mm.leftCols<2>() *= -1.0; };
  EXPECT_EQ(found(turn), (Found{{BadGeometry, "/landmarks/posteromedial_commissure"},
                                {BadGeometry, "/landmarks/saddle_peak"}}));
}

TEST(ValidateAnnulus, LandmarksLieOnTheAnnulusInOrder) {
  EXPECT_EQ(found([](Valve& v) { v.landmarks.saddle_peak = 10; }),
            (Found{{BadReference, "/landmarks/saddle_peak"}}));
  EXPECT_EQ(found([](Valve& v) {
              std::swap(v.landmarks.saddle_peak, v.landmarks.posteromedial_trigone);
            }),
            (Found{{BadGeometry, "/landmarks/saddle_peak"}}));
  EXPECT_EQ(found([](Valve& v) { v.landmarks.posteromedial_trigone = 0; }), Found{});
}

TEST(ValidateHeads, EachSideHasAHeadBelowTheAnnulus) {
  EXPECT_EQ(found([](Valve& v) { v.heads[0].side = Side::Posteromedial; }),
            (Found{{OutOfRange, "/papillary_heads"}}));
  EXPECT_EQ(found([](Valve& v) { v.heads[0].tip_mm.z() = 26.0; }),
            (Found{{BadGeometry, "/papillary_heads/0/tip_mm/2"}}));
  EXPECT_EQ(found([](Valve& v) { v.heads[1].rest_mm.z() = 0.0; }),
            (Found{{BadGeometry, "/papillary_heads/1/rest_mm/2"}}));
  EXPECT_EQ(found([](Valve& v) { v.heads[1].id = "AL1"; }),
            (Found{{BadReference, "/papillary_heads/1/id"}}));
  EXPECT_EQ(found([](Valve& v) { v.heads[1].id = ""; }),
            (Found{{OutOfRange, "/papillary_heads/1/id"}}));
}

TEST(ValidateChordae, ReferencesAndRangesAreNamed) {
  EXPECT_EQ(found([](Valve& v) { v.chordae[1].head = 2; }),
            (Found{{BadReference, "/chordae/1/head"}}));
  EXPECT_EQ(found([](Valve& v) { v.chordae[1].id = v.chordae[0].id; }),
            (Found{{BadReference, "/chordae/1/id"}}));
  EXPECT_EQ(found([](Valve& v) { v.chordae[1].segments.clear(); }),
            (Found{{OutOfRange, "/chordae/1/segments"}}));
  const auto spoil = [](Valve& v) {
    ChordaSegment& segment = v.chordae[0].segments[1];
    segment.rest_length_mm = 0.0;
    segment.diameter_mm = kNan;
    segment.insertion.face = 32;
    segment.insertion.weights = {-0.5, 0.5, 1.0};
    v.chordae[0].segments[0].branch_point_mm.y() = kNan;
  };
  EXPECT_EQ(found(spoil), (Found{{OutOfRange, "/chordae/0/segments/0/branch_point_mm/1"},
                                 {OutOfRange, "/chordae/0/segments/1/rest_length_mm"},
                                 {OutOfRange, "/chordae/0/segments/1/diameter_mm"},
                                 {BadReference, "/chordae/0/segments/1/insertion/face"},
                                 {OutOfRange, "/chordae/0/segments/1/insertion/weights/0"}}));
  EXPECT_EQ(found([](Valve& v) {
              v.chordae[1].segments[0].insertion.weights = {0.3, 0.3, 0.3};
            }),
            (Found{{OutOfRange, "/chordae/1/segments/0/insertion/weights"}}));
}

TEST(ValidateChordae, ParentsAreEarlierSegments) {
  EXPECT_EQ(found([](Valve& v) { v.chordae[0].segments[1].parent = 3; }),
            (Found{{BadReference, "/chordae/0/segments/1/parent"}}));
  EXPECT_EQ(found([](Valve& v) { v.chordae[0].segments[1].parent = -2; }),
            (Found{{BadReference, "/chordae/0/segments/1/parent"}}));
  const auto trunk_last = [](Valve& v) {
    auto& segments = v.chordae[0].segments;
    std::swap(segments[0], segments[2]);
    segments[0].parent = segments[1].parent = 2;
  };
  EXPECT_EQ(found(trunk_last), (Found{{BadTopology, "/chordae/0/segments/0/parent"},
                                      {BadTopology, "/chordae/0/segments/1/parent"}}));
}

TEST(ValidateChordae, CyclesAreFoundAndWhatHangsOnThemIsUnreached) {
  EXPECT_EQ(found([](Valve& v) { v.chordae[0].segments[0].parent = 0; }),
            (Found{{BadTopology, "/chordae/0/segments/0/parent"},
                   {BadTopology, "/chordae/0/segments/1"},
                   {BadTopology, "/chordae/0/segments/2"}}));
  EXPECT_EQ(first_message([](Valve& v) { v.chordae[0].segments[0].parent = 0; }), "closes a cycle");
}

TEST(ValidateChordae, OnlyBranchPointsGoOnAndAllOfThemDo) {
  EXPECT_EQ(found([](Valve& v) { v.chordae[0].segments[2].parent = 1; }),
            (Found{{BadTopology, "/chordae/0/segments/2/parent"}}));
  EXPECT_EQ(found([](Valve& v) { v.chordae[0].segments.resize(1); }),
            (Found{{BadTopology, "/chordae/0/segments/0"}}));
  EXPECT_EQ(found([](Valve& v) { v.chordae[0].segments[2].parent = -1; }),
            (Found{{BadTopology, "/chordae/0/segments/2/parent"}}));
}

TEST(Validate, ListsTwoHundredProblemsAndCountsTheRest) {
  Valve valve = small_valve();
  for (Chorda& chorda : valve.chordae) chorda.head = 9;
  valve.chordae.resize(251, valve.chordae[1]);
  for (std::size_t i = 0; i < valve.chordae.size(); ++i) valve.chordae[i].id = std::to_string(i);
  const Errors errors = validate(valve);
  ASSERT_EQ(errors.size(), 201u);
  EXPECT_EQ(errors[199].path, "/chordae/199/head");
  EXPECT_EQ(errors[200].path, "");
  EXPECT_EQ(errors[200].message, "51 more problems, not listed");
}

}  // namespace
}  // namespace coapt
