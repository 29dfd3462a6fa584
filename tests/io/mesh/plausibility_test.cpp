#include "io/mesh/plausibility.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "cone_scene.h"
#include "core/valve/vertex_normals.h"

namespace coapt {
namespace {

/// Points on a circle of radius 18 mm, from 0 to `span_deg`, the end left out.
Points arc(double span_deg, int points) {
  Points loop(points, 3);
  for (int i = 0; i < points; ++i) {
    const double angle = span_deg * i / points * std::numbers::pi / 180.0;
    loop.row(i) << 18.0 * std::cos(angle), 18.0 * std::sin(angle), 0.0;
  }
  return loop;
}

TEST(Plausibility, AContourOverAPartOfTheAnnulusIsRefused) {
  for (const double span : {180.0, 250.0, 290.0}) {
    const auto checked = contour_checks(arc(span, 60));
    ASSERT_FALSE(checked) << span;
    EXPECT_EQ(checked.errors()[0].path, "/annulus_mm");
    EXPECT_NE(checked.errors()[0].message.find("is open over"), std::string::npos);
  }
}

TEST(Plausibility, ASmallGapIsLookedAtAndAWholeOneIsNot) {
  const auto gap = contour_checks(arc(320.0, 60));
  ASSERT_TRUE(gap);
  ASSERT_EQ(gap->size(), 1U);
  EXPECT_TRUE((*gap)[0].look);
  for (const int points : {12, 60, 720}) EXPECT_TRUE(contour_checks(arc(360.0, points))->empty());
  Points closed = arc(360.0, 60);
  closed.conservativeResize(61, 3);
  closed.row(60) = closed.row(0);
  EXPECT_TRUE(contour_checks(closed)->empty()) << "the first point again";
}

TEST(Plausibility, AGapBetweenFewPointsIsOneToo) {
  EXPECT_FALSE(contour_checks(arc(288.0, 12))) << "96 degrees are missing";
  EXPECT_TRUE(contour_checks(arc(360.0, 8))->empty());
}

TEST(Plausibility, AStrayPointOfAContourIsNamed) {
  for (const int points : {12, 60, 720}) {
    Points loop = 0.1 * arc(360.0, points);
    EXPECT_EQ(stray_point(loop), "") << points;
    loop.row(4) += Eigen::RowVector3d(0.5, 1.0, 1.0);
    EXPECT_TRUE(stray_point(loop).starts_with("has a stray point: point 5, (")) << points;
  }
  EXPECT_EQ(stray_point(arc(250.0, 60)), "") << "a gap is none";
}

/// Points on the same circle at these shares of it.
Points circle_at(const std::vector<double>& shares) {
  Points loop(std::ssize(shares), 3);
  for (Eigen::Index i = 0; i < loop.rows(); ++i) {
    const double angle = 2.0 * std::numbers::pi * shares[static_cast<std::size_t>(i)];
    loop.row(i) << 18.0 * std::cos(angle), 18.0 * std::sin(angle), 0.0;
  }
  return loop;
}

TEST(Plausibility, UnevenlySpacedPointsOfAContourAreNotStray) {
  std::vector<double> two_thirds, one_by_one = {0.0, 0.02, 0.04, 0.06, 0.08, 0.1, 0.4, 0.6, 0.8};
  for (int i = 0; i < 200; ++i) two_thirds.push_back(0.0033 * i);
  two_thirds.insert(two_thirds.end(), {0.66, 0.83});
  std::vector<double> pairs;
  for (int i = 0; i < 6; ++i) pairs.insert(pairs.end(), {i / 6.0, i / 6.0 + 0.002});
  for (const std::vector<double>& shares : {two_thirds, one_by_one, pairs}) {
    Points loop = circle_at(shares);
    EXPECT_EQ(stray_point(loop), "") << shares.size();
    const Eigen::Index last = loop.rows() - 1;
    for (const Eigen::Index moved : {Eigen::Index{3}, last}) {
      if (moved == last && shares.size() == one_by_one.size()) continue;  // alone over two fifths
      Points wrong = loop;
      wrong.row(moved) += Eigen::RowVector3d(3.0, 5.0, 14.0);
      EXPECT_TRUE(stray_point(wrong).starts_with("has a stray point: point " +
                                                 std::to_string(moved + 1) + ", ("))
          << shares.size() << ' ' << stray_point(wrong);
    }
  }
}

TEST(Plausibility, AContourTwiceRoundIsRefused) {
  const auto checked = contour_checks(arc(720.0, 120));
  ASSERT_FALSE(checked);
  EXPECT_NE(checked.errors()[0].message.find("2 times"), std::string::npos);
}

std::vector<std::string> looked_at(const ImportSource& source, const ImportOptions& options = {}) {
  const Expected<ImportedValve> made = import_with_decisions(source, options);
  std::vector<std::string> subjects;
  if (made)
    for (const ImportDecision& decision : made->decisions)
      if (decision.look) subjects.push_back(decision.subject);
  return subjects;
}

/// In an annulus whose front and back rise by `saddle_mm` over its sides, `depth` of its own.
ImportSource saddled(ImportSource source, double saddle_mm, double depth = 1.0) {
  const auto raised = [&](Points& points) {
    for (auto point : points.rowwise()) {
      const double cosine = 2.0 * std::pow(point.y() / point.head<2>().norm(), 2) - 1.0;
      point.z() = depth * point.z() + 0.5 * saddle_mm * cosine;
    }
  };
  for (TriangleMesh& mesh : source.leaflets) raised(mesh.vertices_mm);
  raised(source.annulus_mm);
  for (ImportedChorda& chorda : source.chordae) {
    Points insertion = chorda.insertion_mm.transpose();
    raised(insertion);
    chorda.insertion_mm = insertion.row(0);
  }
  return source;
}

TEST(Plausibility, TipsBesideTheValveAreLookedAt) {
  ImportSource source = cone_source();
  ImportOptions options;
  options.chordae_seed = 1;
  const auto with_tips = [&](double across_mm, double front_mm) {
    source.chordae.clear();
    source.tips = {{Side::Anterolateral, {-across_mm, front_mm, -25.0}},
                   {Side::Posteromedial, {across_mm, front_mm, -25.0}}};
    const std::vector<std::string> looks = looked_at(source, options);
    return std::count(looks.begin(), looks.end(), "size");
  };
  const auto usual = with_tips(10.0, -3.0);
  EXPECT_EQ(with_tips(10.0, 17.0), usual + 1) << "in front";
  EXPECT_EQ(with_tips(45.0, -3.0), usual + 1) << "to the sides";
}

TEST(Plausibility, SizesOfNoHeartAreLookedAt) {
  EXPECT_TRUE(looked_at(saddled(cone_source(), 4.0)).empty());
  EXPECT_EQ(looked_at(cone_source()), std::vector<std::string>{"size"}) << "a flat annulus";
  ImportSource large = cone_source(), small = cone_source();
  for (const auto& [source, factor] : {std::pair(&large, 2.2), {&small, 0.5}}) {
    for (TriangleMesh& mesh : source->leaflets) mesh.vertices_mm *= factor;
    source->annulus_mm *= factor;
    for (ImportedChorda& chorda : source->chordae) {
      chorda.insertion_mm *= factor;
      chorda.tip_mm *= factor;
    }
    const auto subjects = looked_at(*source, {.units = LengthUnit::Millimetre});
    EXPECT_NE(std::find(subjects.begin(), subjects.end(), "size"), subjects.end()) << factor;
  }
}

TEST(Plausibility, AnAnnulusDeeperThanWideIsLookedAt) {
  ImportSource stretched = saddled(cone_source(), 4.0);
  for (TriangleMesh& mesh : stretched.leaflets) mesh.vertices_mm.col(1) *= 1.15;
  stretched.annulus_mm.col(1) *= 1.15;
  const auto subjects = looked_at(stretched);
  EXPECT_NE(std::find(subjects.begin(), subjects.end(), "size"), subjects.end());
}

TEST(Plausibility, LeafletsTooShortOrTooTallForTheirAnnulusAreLookedAt) {
  // Of the cone both heights together are 0.90 of the diameter.
  for (const double depth : {0.7, 2.6}) {
    ImportSource source = saddled(cone_source(), 4.0, depth);
    for (ImportedChorda& chorda : source.chordae) chorda.tip_mm.z() -= 30.0;
    const auto subjects = looked_at(source);
    EXPECT_NE(std::find(subjects.begin(), subjects.end(), "size"), subjects.end()) << depth;
  }
}

TEST(Plausibility, AContourBesideTheLeafletsIsLookedAtBeyondItsBand) {
  ImportSource source = cone_source();
  source.annulus_mm.col(2).array() += 2.5;
  const auto has_contour = [&] {
    const auto subjects = looked_at(source);
    return std::find(subjects.begin(), subjects.end(), "contour") != subjects.end();
  };
  EXPECT_TRUE(has_contour());
  source.annulus_band_mm = 1.2;
  EXPECT_TRUE(has_contour());
  source.annulus_band_mm = 1.8;
  EXPECT_FALSE(has_contour());
}

/// Two sheets without tips.
ImportSource flat_sheets(double saddle_mm, double depth) {
  ImportSource source = saddled(cone_source_with_gaps(), saddle_mm, depth);
  source.chordae.clear();
  return source;
}

TEST(Plausibility, TheAtriumIsNotToldByASignOfRounding) {
  ImportOptions drawn;
  drawn.closed = false;
  drawn.chordae_seed = 1;
  const auto made = [&](double saddle_mm, double depth) {
    return import_with_decisions(flat_sheets(saddle_mm, depth), drawn);
  };
  const auto atrium = [](const ImportedValve& valve) {
    return *std::find_if(valve.decisions.begin(), valve.decisions.end(),
                         [](const ImportDecision& of) { return of.subject == "atrium"; });
  };
  const Expected<ImportedValve> flat = made(0.0, 0.05);
  ASSERT_FALSE(flat);
  EXPECT_EQ(flat.errors()[0].path, "/tips");
  const Expected<ImportedValve> hangs = made(4.0, 1.0);
  ASSERT_TRUE(hangs) << hangs.errors()[0].message;
  EXPECT_FALSE(atrium(*hangs).look);
  const Expected<ImportedValve> disagrees = made(-4.0, 1.0);
  ASSERT_TRUE(disagrees) << disagrees.errors()[0].message;
  EXPECT_TRUE(atrium(*disagrees).look);
}

TEST(Plausibility, NamedChambersTellTheAtriumOrDisagree) {
  const auto framed = [](double depth, double saddle_mm, AnnulusSide side, double up_mm) {
    ImportSource source = flat_sheets(saddle_mm, depth);
    source.witnesses = {{side, {0.0, 0.0, up_mm}}};
    return into_import_frame(source, {true, false, false});
  };
  const Expected<FramedSource> hangs = framed(1.0, 4.0, AnnulusSide::Atrium, 20.0),
                               against = framed(1.0, 4.0, AnnulusSide::Ventricle, 20.0),
                               beside = framed(1.0, 4.0, AnnulusSide::Ventricle, 2.0),
                               flat = framed(0.05, 0.0, AnnulusSide::Ventricle, 20.0);
  ASSERT_TRUE(hangs && against && beside && flat);
  EXPECT_FALSE(hangs->atrium.look) << sentence(hangs->atrium);
  EXPECT_NE(hangs->atrium.reason.find("this side, too"), std::string::npos);
  EXPECT_TRUE(against->atrium.look) << sentence(against->atrium);
  EXPECT_GT(against->patient.axes(2, 2), 0.0) << "as they hang";
  EXPECT_FALSE(beside->atrium.look) << sentence(beside->atrium);
  EXPECT_FALSE(flat->atrium.look) << sentence(flat->atrium);
  EXPECT_LT(flat->patient.axes(2, 2), 0.0) << "nothing else tells";
}

TEST(Plausibility, AFlipAgainstHangingAndSaddleIsLookedAt) {
  const auto flipped = [](double saddle_mm) {
    return into_import_frame(flat_sheets(saddle_mm, 1.0), {true, false, true});
  };
  const Expected<FramedSource> against = flipped(4.0), with_saddle = flipped(-4.0);
  ASSERT_TRUE(against && with_saddle);
  EXPECT_TRUE(against->atrium.look);
  EXPECT_FALSE(with_saddle->atrium.look);
}

TEST(Plausibility, AShellThatIsStretchedIsThickerAlongOneDirection) {
  const TriangleMesh sheet = cone(0, 360);
  const Points normals = vertex_normals(sheet.vertices_mm, sheet.faces);
  const auto told = [&](const Vec3& stretch) {
    MeasuredThickness measured;
    for (const auto& normal : normals.rowwise())
      measured.vertices_mm.push_back(1.6 * stretch.cwiseProduct(normal.transpose()).norm());
    return thickness_checks({sheet}, {measured});
  };
  EXPECT_TRUE(told({1.0, 1.0, 1.0}).empty());
  EXPECT_TRUE(told({1.0, 1.2, 1.0}).empty());
  const std::vector<ImportDecision> stretched = told({1.0, 1.8, 1.0});
  ASSERT_EQ(stretched.size(), 1U);
  EXPECT_TRUE(stretched[0].look);
}

}  // namespace
}  // namespace coapt
