#include "io/mesh/import_valve.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "cone_scene.h"
#include "core/valve/number_text.h"
#include "core/valve/patient_frame.h"
#include "core/valve/validate.h"

namespace coapt {
namespace {

constexpr double kFacet_mm = 0.01;  // the cone's facets of a degree are this far from the cone

Valve imported(const ImportSource& source, const ImportOptions& options = {}) {
  const Expected<Valve> valve = import_valve(source, options);
  EXPECT_TRUE(valve) << valve.errors()[0].path << ": " << valve.errors()[0].message;
  return valve ? *valve : Valve{};
}

double degrees(const Vec3& point) {
  return std::atan2(point.y(), point.x()) * 180.0 / std::numbers::pi;
}

/// Every vertex lies at its row's place on the cone.
void expect_cone(const Valve& valve) {
  const auto stations = std::ssize(valve.annulus);
  const auto rows = valve.rest_mm.rows() / stations - 1;
  for (Eigen::Index v = 0; v < valve.rest_mm.rows(); ++v) {
    const Vec3 point = valve.rest_mm.row(v);
    const double share = static_cast<double>(v / stations) / static_cast<double>(rows);
    EXPECT_LT((point - on_cone(degrees(point), share)).norm(), kFacet_mm) << v;
  }
}

/// Boundary loops of a mesh: their numbers of edges.
std::vector<int> boundary_loops(const Faces& faces) {
  std::map<std::pair<int, int>, int> directed;
  for (Eigen::Index f = 0; f < faces.rows(); ++f) {
    for (int k = 0; k < 3; ++k) ++directed[{faces(f, k), faces(f, (k + 1) % 3)}];
  }
  std::map<int, int> next;
  for (const auto& [edge, count] : directed) {
    if (!directed.contains({edge.second, edge.first})) next[edge.first] = edge.second;
  }
  std::vector<int> loops;
  while (!next.empty()) {
    int edges = 0;
    for (auto at = next.begin(); at != next.end(); ++edges) {
      const int to = at->second;
      next.erase(at);
      at = next.find(to);
    }
    loops.push_back(edges);
  }
  return loops;
}

TEST(ImportValve, AConeIsGivenBack) {
  const Valve valve = imported(cone_source());
  EXPECT_EQ(valve.rest_mm.rows(), 60 * 7);
  EXPECT_EQ(valve.faces.rows(), 720);
  expect_cone(valve);
  EXPECT_TRUE(validate(valve).empty());
}

TEST(ImportValve, KnowsTheWayBackToItsImages) {
  ImportSource moved = cone_source();
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(1.9, Vec3(1.0, -2.0, 0.5).normalized()).toRotationMatrix();
  const Vec3 scanner(-31.0, 84.0, 1200.0);
  const auto place = [&](const Vec3& point) { return Vec3(turn * point + scanner); };
  for (TriangleMesh& sheet : moved.leaflets)
    for (Eigen::Index v = 0; v < sheet.vertices_mm.rows(); ++v)
      sheet.vertices_mm.row(v) = place(sheet.vertices_mm.row(v));
  for (Eigen::Index i = 0; i < moved.annulus_mm.rows(); ++i)
    moved.annulus_mm.row(i) = place(moved.annulus_mm.row(i));
  for (ImportedChorda& chorda : moved.chordae) {
    chorda.insertion_mm = place(chorda.insertion_mm);
    chorda.tip_mm = place(chorda.tip_mm);
  }
  const Valve valve = imported(moved), own = imported(cone_source());
  ASSERT_TRUE(valve.patient);
  EXPECT_TRUE(validate(valve).empty());
  const Points back = to_patient(*valve.patient, valve.rest_mm);
  for (Eigen::Index v = 0; v < back.rows(); ++v)
    EXPECT_LT((Vec3(back.row(v)) - place(own.rest_mm.row(v))).norm(), 1e-6) << v;
}

TEST(ImportValve, GapsAtTheCommissuresAreClosed) {
  const Valve valve = imported(cone_source_with_gaps());
  expect_cone(valve);
  EXPECT_EQ(boundary_loops(valve.faces), (std::vector<int>{60, 60}));
  EXPECT_TRUE(validate(valve).empty());
}

TEST(ImportValve, CommissuresAreWhereTheSheetsMeet) {
  const Valve valve = imported(cone_source_with_gaps());
  const auto at = [&](int vertex) { return Vec3(valve.rest_mm.row(vertex)); };
  EXPECT_NEAR(degrees(at(valve.landmarks.posteromedial_commissure)), 0.0, 0.5);
  EXPECT_NEAR(std::abs(degrees(at(valve.landmarks.anterolateral_commissure))), 180.0, 3.0);
  EXPECT_NEAR(degrees(at(valve.landmarks.saddle_peak)), 90.0, 3.0);
  EXPECT_NEAR(degrees(at(valve.landmarks.mid_posterior)), -90.0, 3.0);
  EXPECT_EQ(std::count(valve.segments.begin(), valve.segments.end(), Segment::A2), 120);
  EXPECT_EQ(std::count(valve.segments.begin(), valve.segments.end(), Segment::P2), 120);
}

TEST(ImportValve, AnyResolutionIsMade) {
  ImportOptions options;
  for (const int triangles : {100, 1400, 2600, 10400}) {
    options.triangles = triangles;
    const Valve valve = imported(cone_source(), options);
    EXPECT_NEAR(static_cast<double>(valve.faces.rows()), triangles, 0.1 * triangles);
    expect_cone(valve);
  }
}

TEST(ImportValve, FibresLieAlongTheAnnulus) {
  const Valve valve = imported(cone_source());
  for (Eigen::Index f = 0; f < valve.faces.rows(); ++f) {
    EXPECT_NEAR(valve.fibre.row(f).norm(), 1.0, 1e-12);
    EXPECT_NEAR(valve.fibre(f, 2), 0.0, 1e-3);
  }
}

TEST(ImportValve, AnAnnulusUnderPressureAndATreeOfChordaeAreKept) {
  ImportSource source = cone_source();
  source.pressed_annulus_mm = 1.1 * source.annulus_mm;
  source.chordae[0].pressed_tip_mm = Vec3(-10.0, 0.0, -28.0);
  source.chordae[1].segments = {{-1, {11.0, 0.0, -20.0}, false, 6.0, 1.5},
                                {0, on_cone(0.0, 1.0), true, {}, 0.8},
                                {0, on_cone(10.0, 1.0), true, {}, 0.8}};
  ImportOptions options;
  options.slack = 1.2;
  const Valve valve = imported(source, options);
  EXPECT_LT((valve.annulus_mm - 1.1 * valve.rest_mm.topRows(60)).norm(), 1e-9);
  EXPECT_EQ(valve.heads[0].tip_mm - valve.heads[0].rest_mm, Vec3(0.0, 0.0, -3.0));
  const std::vector<ChordaSegment>& segments = valve.chordae[1].segments;
  ASSERT_EQ(segments.size(), 3U);
  EXPECT_DOUBLE_EQ(segments[0].rest_length_mm, 6.0);  // nothing moved, so as it was given
  EXPECT_DOUBLE_EQ(segments[0].diameter_mm, 1.5);
  // From (11, 0, -20) to (12, 0, -15), with slack.
  EXPECT_NEAR(segments[1].rest_length_mm, 1.2 * std::sqrt(26.0), 0.05);
  EXPECT_EQ(valve.chordae[1].kind, ChordaKind::Marginal);
}

TEST(ImportValve, AStraightChordaIsAsLongAsItsDistanceTimesSlack) {
  ImportOptions options;
  options.branches = 1;
  options.slack = 1.1;
  const Valve valve = imported(cone_source(), options);
  ASSERT_EQ(valve.chordae.size(), 2U);
  ASSERT_EQ(valve.chordae[1].segments.size(), 1U);
  // From (10, 0, -25) to (12, 0, -15).
  EXPECT_NEAR(valve.chordae[1].segments[0].rest_length_mm, 1.1 * std::sqrt(104.0), 0.05);
}

TEST(ImportValve, AMarginalChordaBranchesWhereItIsTold) {
  ImportOptions options;
  options.branches = 3;
  options.branch_at = 0.6;
  const Valve valve = imported(cone_source(), options);
  const Chorda& chorda = valve.chordae[1];
  ASSERT_EQ(chorda.segments.size(), 4U);
  Vec3 mean = Vec3::Zero();
  for (std::size_t i = 1; i < 4; ++i) {
    EXPECT_EQ(chorda.segments[i].parent, 0);
    const Vec3 end = position(chorda.segments[i].insertion, valve.faces, valve.rest_mm);
    EXPECT_NEAR(end.z(), -kDepth_mm, kFacet_mm);
    // A sixtieth of the circle to either side: 6 degrees.
    EXPECT_NEAR(degrees(end), 6.0 * (static_cast<double>(i) - 2.0), 0.1);
    mean += end / 3.0;
  }
  const Vec3 tip(10.0, 0.0, -25.0);
  EXPECT_LT((chorda.segments[0].branch_point_mm - (tip + 0.6 * (mean - tip))).norm(), 1e-9);
  EXPECT_NEAR(chorda.segments[0].rest_length_mm, 0.6 * (mean - tip).norm(), 1e-9);
}

TEST(ImportValve, AnInsertionFarFromTheFreeEdgeBecomesStrutOrBasal) {
  ImportSource source = cone_source();
  source.chordae.push_back(
      {"s", Side::Anterolateral, ChordaKind::Marginal, on_cone(93.0, 0.5), {-10.0, 0.0, -25.0}});
  source.chordae.push_back(
      {"t", Side::Posteromedial, ChordaKind::Marginal, on_cone(-87.0, 0.5), {10.0, 0.0, -25.0}});
  const Valve valve = imported(source);
  EXPECT_EQ(valve.chordae[2].kind, ChordaKind::Strut);
  EXPECT_EQ(valve.chordae[3].kind, ChordaKind::Basal);
  ASSERT_EQ(valve.chordae[2].segments.size(), 1U);
  const Vec3 end = position(valve.chordae[2].segments[0].insertion, valve.faces, valve.rest_mm);
  EXPECT_LT((end - on_cone(93.0, 0.5)).norm(), 0.05);  // facets of six degrees
}

/// What is decided of chordae that end `up_mm` above six points of the free edge.
ImportDecision chordae_decision(double up_mm) {
  ImportSource source = cone_source();
  for (const double angle : {60.0, 120.0, -60.0, -120.0}) {
    const bool medial = std::abs(angle) < 90.0;
    source.chordae.push_back({shown(angle), medial ? Side::Posteromedial : Side::Anterolateral,
                              ChordaKind::Marginal, on_cone(angle, 1.0),
                              Vec3(medial ? 10.0 : -10.0, 0.0, -25.0)});
  }
  for (ImportedChorda& chorda : source.chordae) chorda.insertion_mm.z() += up_mm;
  const Expected<ImportedValve> made = import_with_decisions(source, {});
  if (made)
    for (const ImportDecision& decision : made->decisions)
      if (decision.subject == "chordae") return decision;
  return {};
}

TEST(ImportValve, ATableOfChordaeThatLiesElsewhereIsLookedAt) {
  for (const double up_mm : {0.0, 1.0, -1.0}) EXPECT_FALSE(chordae_decision(up_mm).look) << up_mm;
  for (const double up_mm : {2.0, -2.0}) {
    const ImportDecision moved = chordae_decision(up_mm);
    EXPECT_TRUE(moved.look);
    EXPECT_NE(moved.reason.find(" mm on average"), std::string::npos) << moved.reason;
  }
  const ImportDecision high = chordae_decision(4.5);
  EXPECT_TRUE(high.look);
  EXPECT_NE(high.reason.find("of the anterior leaflet ends within 3 mm of its free edge"),
            std::string::npos)
      << high.reason;
}

TEST(ImportValve, DistinctTipsBecomeHeadsOfTheirMuscle) {
  ImportSource source = cone_source();
  source.chordae.push_back(
      {"c", Side::Posteromedial, ChordaKind::Marginal, on_cone(30.0, 1.0), {10.0, 3.0, -24.0}});
  source.chordae.push_back(
      {"d", Side::Posteromedial, ChordaKind::Marginal, on_cone(-30.0, 1.0), {10.0, 0.0, -25.0}});
  source.chordae[0].tip_mm.y() = 1.5;  // keeps the mean tips level
  const Valve valve = imported(source);
  ASSERT_EQ(valve.heads.size(), 3U);
  EXPECT_EQ(valve.heads[0].id, "AL1");
  EXPECT_EQ(valve.heads[1].id, "PM1");
  EXPECT_GT(valve.heads[1].tip_mm.y(), valve.heads[2].tip_mm.y());
  EXPECT_EQ(valve.chordae[2].head, 1);
  EXPECT_EQ(valve.chordae[1].head, 2);
  EXPECT_EQ(valve.chordae[3].head, 2);
}

TEST(ImportValve, ChangesAreToldAfterTheSources) {
  const Valve valve = imported(cone_source_with_gaps());
  ASSERT_GE(valve.provenance.size(), 5U);
  EXPECT_EQ(valve.provenance[0], "made by hand");
  const auto told = [&](const char* words) {
    return std::any_of(
        valve.provenance.begin(), valve.provenance.end(),
        [&](const std::string& line) { return line.find(words) != std::string::npos; });
  };
  EXPECT_TRUE(told("frame: moved by"));
  EXPECT_TRUE(told("60 stations"));
  EXPECT_TRUE(told("stations without a sheet interpolated"));
  EXPECT_TRUE(told("2 marginal"));
}

}  // namespace
}  // namespace coapt
