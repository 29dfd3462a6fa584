#include "core/valve/parametric.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>

#include "core/valve/contour.h"
#include "core/valve/validate.h"

namespace coapt {
namespace {

double perimeter(const Points& contour) { return ArcLength(contour).total_mm(); }

TEST(Contour, OfHumanControlsHasTheirPublishedCircumferenceAndArea) {
  const Points contour = generic_annulus_contour(29.0, 39.0, 6.8);
  double area = 0.0;
  for (Eigen::Index i = 0; i < contour.rows(); ++i) {
    const Eigen::Index j = (i + 1) % contour.rows();
    area += 0.5 * (contour(i, 0) * contour(j, 1) - contour(j, 0) * contour(i, 1));
  }
  EXPECT_NEAR(perimeter(contour), 116.0, 3.5);  // PMC7368231
  EXPECT_NEAR(area, 980.0, 50.0);
  EXPECT_NEAR(contour.col(0).maxCoeff() - contour.col(0).minCoeff(), 39.0, 1e-9);
  EXPECT_NEAR(contour.col(1).maxCoeff() - contour.col(1).minCoeff(), 29.0, 0.01);
}

TEST(ArcLength, OfASquareWalksItsSides) {
  Points square(4, 3);
  square << 1, -1, 0, 1, 1, 0, -1, 1, 0, -1, -1, 0;
  const ArcLength arc(square);
  EXPECT_DOUBLE_EQ(arc.total_mm(), 8.0);
  EXPECT_EQ(arc.at(0.5), Vec3(1, -0.5, 0));
  EXPECT_EQ(arc.at(8.0 + 3.0), Vec3(0, 1, 0));
  EXPECT_EQ(arc.at(-1.0), Vec3(0, -1, 0));
  EXPECT_DOUBLE_EQ(arc.crossing_mm(true), 3.0);
  EXPECT_DOUBLE_EQ(arc.crossing_mm(false), 7.0);
}

TEST(IntoValveFrame, TakesTheSideOfTheTipsForPosteriorWhereTheContourSaysLittle) {
  Points ellipse(24, 3);
  for (int i = 0; i < 24; ++i)
    ellipse.row(i) << 20.0 * std::cos(i * 0.2618), 15.0 * std::sin(i * 0.2618), 0.0;
  Points tips(2, 3);
  for (const double side : {1.0, -1.0}) {
    tips << -12.0, side * 5.0, -24.0, 12.0, side * 5.0, -24.0;
    EXPECT_NEAR(into_valve_frame(ellipse, tips).tips_mm(0, 1), -5.0, 1e-6);
  }
  // A bulge of 2 mm on the anterior side does not outweigh tips 20 mm behind.
  for (int i = 0; i < 24; ++i)
    if (ellipse(i, 1) > 14.0) ellipse(i, 1) += 2.0;
  tips << -12.0, -20.0, -24.0, 12.0, -20.0, -24.0;
  EXPECT_LT(into_valve_frame(ellipse, tips).tips_mm(0, 1), -19.0);
}

TEST(IntoValveFrame, TakesTheFlatterSideForAnteriorWhereTheTipsSayNothing) {
  const Points contour = generic_annulus_contour(29.0, 39.0, 0.0);
  Points tips(2, 3);
  tips << -12.0, 0.0, -24.0, 12.0, 0.0, -24.0;
  const Points framed = into_valve_frame(contour, tips).annulus_mm;
  EXPECT_NEAR(framed.col(1).maxCoeff(), contour.col(1).maxCoeff(), 1e-6);
}

TEST(ParametricValve, HasTheLeafletHeightsAndResolutionAskedFor) {
  for (const int triangles : {650, 2600, 10400}) {
    ParametricValve d;
    d.triangles = triangles;
    const Valve valve = *make_parametric_valve(d);
    EXPECT_TRUE(validate(valve).empty());
    EXPECT_NEAR(static_cast<double>(valve.faces.rows()), triangles, 0.04 * triangles);
    const Index stations = std::ssize(valve.annulus);
    const Eigen::Index last_row = valve.rest_mm.rows() - stations;
    const auto height = [&](int vertex) {
      return (valve.rest_mm.row(last_row + vertex) - valve.rest_mm.row(vertex)).norm();
    };
    EXPECT_NEAR(height(valve.landmarks.saddle_peak), 23.5, 1e-9);
    EXPECT_NEAR(height(valve.landmarks.mid_posterior), 15.25, 1e-9);
    EXPECT_NEAR(height(valve.landmarks.posteromedial_commissure), 9.0, 1e-9);
  }
}

TEST(ParametricValve, OfTwoLikeHalvesHasAsManyFacesInEachSegmentOfEither) {
  const Expected<Valve> valve = make_parametric_valve(ParametricValve{});
  ASSERT_TRUE(valve);
  std::map<Segment, int> faces;
  for (const Segment segment : valve->segments) ++faces[segment];
  EXPECT_EQ(faces.size(), 8u);
  EXPECT_EQ(faces[Segment::A1], faces[Segment::A3]);
  EXPECT_EQ(faces[Segment::P1], faces[Segment::P3]);
  EXPECT_EQ(faces[Segment::AC], faces[Segment::PC]);
}

TEST(ParametricValve, InclinesEachLeafletByItsOwnAngleAndOutwardsIfNegative) {
  ParametricValve d;
  d.anterior_inclination_deg = 30.0;
  d.posterior_inclination_deg = -15.0;
  const Valve valve = *make_parametric_valve(d);
  EXPECT_TRUE(validate(valve).empty());
  const Index last_row = valve.rest_mm.rows() - std::ssize(valve.annulus);
  const auto inwards_deg = [&](int vertex, double inwards) {
    const Vec3 way = valve.rest_mm.row(last_row + vertex) - valve.rest_mm.row(vertex);
    return std::atan2(inwards * way.y(), -way.z()) * 180.0 / 3.14159265358979;
  };
  EXPECT_NEAR(inwards_deg(valve.landmarks.saddle_peak, -1.0), 30.0, 1e-6);
  EXPECT_NEAR(inwards_deg(valve.landmarks.mid_posterior, 1.0), -15.0, 1e-6);
}

TEST(ParametricValve, FoldsTheFreeEdgeWhereScallopsMeet) {
  for (const int triangles : {650, 2600}) {
    ParametricValve d;
    d.triangles = triangles;
    const Valve flat = *make_parametric_valve(d);
    d.posterior_fold_mm = 5.0;
    d.anterior_fold_mm = 4.0;
    const Valve folded = *make_parametric_valve(d);
    const auto stations = static_cast<Index>(flat.annulus.size());
    const Index rows = flat.rest_mm.rows() / stations;
    const Points moved = folded.rest_mm - flat.rest_mm;
    EXPECT_EQ(moved.topRows(stations * (rows / 3)).norm(), 0.0);
    double edge_mm = 0.0;
    const Index first = stations * (rows - 1);
    for (Index i = 0; i < stations; ++i) {
      const Index next = first + (i + 1) % stations;
      edge_mm += (folded.rest_mm.row(next) - folded.rest_mm.row(first + i)).norm() -
                 (flat.rest_mm.row(next) - flat.rest_mm.row(first + i)).norm();
    }
    // Each flank adds less than its height.
    EXPECT_GT(edge_mm, 12.0) << triangles;
    EXPECT_LT(edge_mm, 2 * (2 * 5.0 + 2 * 4.0)) << triangles;
    for (Index i = 0; i < stations; ++i) {
      const Vec3 by = moved.row(first + i);
      const Vec3 inwards = -Vec3(flat.rest_mm(i, 0), flat.rest_mm(i, 1), 0.0);
      if (by.norm() == 0.0) continue;
      EXPECT_EQ(by.dot(inwards) > 0.0, flat.rest_mm(i, 1) > 0.0) << "inwards in front alone";
    }
  }
}

TEST(ParametricValve, NamesItsChordaeAlikeAtEveryResolution) {
  const auto ids = [](int triangles) {
    ParametricValve d;
    d.triangles = triangles;
    std::vector<std::string> list;
    const Valve valve = *make_parametric_valve(d);
    for (const Chorda& chorda : valve.chordae) list.push_back(chorda.id);
    return list;
  };
  const std::vector<std::string> expected = {
      "AL1-A2-marginal-1", "AL1-A1-marginal-2", "AL2-AC-marginal-3", "AL3-P1-marginal-4",
      "AL3-P2-marginal-5", "AL1-A2-strut-6",    "AL3-P1-basal-7",    "AL3-P2-basal-8",
      "PM1-A2-marginal-1", "PM1-A3-marginal-2", "PM2-PC-marginal-3", "PM3-P3-marginal-4",
      "PM3-P2-marginal-5", "PM1-A2-strut-6",    "PM3-P3-basal-7",    "PM3-P2-basal-8"};
  for (const int triangles : {300, 650, 1000, 2000, 2600, 10400})
    EXPECT_EQ(ids(triangles), expected) << triangles;
}

TEST(ParametricValve, LeftOutHeightsFollowTheDiametersAndGivenOnesStay) {
  ParametricValve d;
  d.lateral_height_mm = 12.0;
  const Proportions of_human = proportions(d, 29.0, 39.0);
  EXPECT_EQ(of_human.anterior_height_mm, 23.5);
  EXPECT_EQ(of_human.saddle_height_mm, 6.8);
  const Proportions twice = proportions(d, 58.0, 39.0);
  EXPECT_EQ(twice.anterior_height_mm, 47.0);
  EXPECT_EQ(twice.posterior_height_mm, 30.5);
  EXPECT_EQ(twice.lateral_height_mm, 12.0);
  EXPECT_EQ(twice.commissure_height_mm, 9.0);
  EXPECT_EQ(proportions(d, 29.0, 78.0).commissure_height_mm, 18.0);
}

TEST(ParametricValve, NamesEveryDimensionOutsideItsRange) {
  ParametricValve d;
  d.ap_mm = std::numeric_limits<double>::quiet_NaN();
  d.anterior_height_mm = 0.022;  // metres
  d.triangles = 2000000000;
  const Expected<Valve> valve = make_parametric_valve(d);
  ASSERT_FALSE(valve);
  ASSERT_EQ(valve.errors().size(), 3u);
  EXPECT_EQ(valve.errors()[0].path, "/ap_mm");
  EXPECT_EQ(valve.errors()[1].path, "/anterior_height_mm");
  EXPECT_EQ(valve.errors()[2].path, "/triangles");
}

TEST(ParametricValve, FromAMeasuredContourDoesNotDependOnTheFrameOfTheMeasurement) {
  ParametricValve d;
  d.annulus_mm = generic_annulus_contour(29.0, 39.0, 0.0);
  Points tips(4, 3);
  tips << -12, 1, -23, -12, -3, -23, 12, 1, -24, 12, -3, -24;
  d.tips_mm = tips;
  const Valve here = *make_parametric_valve(d);
  const Eigen::Matrix3d r =
      Eigen::AngleAxisd(2.0, Vec3(1, -2, 0.5).normalized()).toRotationMatrix();
  d.annulus_mm =
      ((*d.annulus_mm * r.transpose()).rowwise() + Eigen::RowVector3d(100, 400, 200)).eval();
  d.tips_mm = ((tips * r.transpose()).rowwise() + Eigen::RowVector3d(100, 400, 200)).eval();
  const Valve there = *make_parametric_valve(d);
  EXPECT_LT((here.rest_mm - there.rest_mm).cwiseAbs().maxCoeff(), 1e-6);
  EXPECT_TRUE(validate(here).empty());
}

TEST(ParametricValve, OnAPlanarContourGetsTheSaddleItIsAskedFor) {
  ParametricValve d;
  d.annulus_mm = generic_annulus_contour(29.0, 39.0, 0.0);
  Points tips(2, 3);
  tips << -12, -2, -23.5, 12, -2, -23.5;
  d.tips_mm = tips;
  const auto height = [&d] {
    const Eigen::VectorXd z = make_parametric_valve(d)->annulus_mm.col(2);
    return z.maxCoeff() - z.minCoeff();
  };
  EXPECT_NEAR(height(), 6.8, 0.1);
  d.saddle_height_mm = 3.0;
  EXPECT_NEAR(height(), 3.0, 0.1);
  d.saddle_height_mm = 0.0;
  EXPECT_NEAR(height(), 0.0, 1e-9);
  d.annulus_mm = generic_annulus_contour(29.0, 39.0, 6.8);
  EXPECT_EQ(make_parametric_valve(d).errors()[0].path, "/saddle_height_mm");
  d.saddle_height_mm.reset();
  EXPECT_NEAR(height(), 7.4, 0.1) << "its own, over its own plane";
}

TEST(ParametricValve, OnAMeasuredContourNamesItsFilesAndTheSaddleItWasGiven) {
  ParametricValve d;
  d.annulus_mm = generic_annulus_contour(29.0, 39.0, 0.0);
  Points tips(2, 3);
  tips << -12, -2, -23.5, 12, -2, -23.5;
  d.tips_mm = tips;
  d.annulus_source = "ring.csv";
  d.tips_source = "tips.csv";
  const std::vector<std::string> provenance = make_parametric_valve(d)->provenance;
  ASSERT_EQ(provenance.size(), 4u);
  EXPECT_EQ(provenance[1],
            "annulus: 720 measured points of ring.csv, planar; saddle of 6.8 mm added by coapt");
  EXPECT_EQ(provenance[2], "papillary tips: 2 measured points of tips.csv");
  d.saddle_height_mm = 0.0;
  EXPECT_EQ(make_parametric_valve(d)->provenance[1], "annulus: 720 measured points of ring.csv");
}

TEST(ParametricValve, WithAMeasuredAnnulusButNoTipsSaysWhatIsMissing) {
  ParametricValve d;
  d.annulus_mm = generic_annulus_contour(29.0, 39.0, 0.0);
  const Expected<Valve> valve = make_parametric_valve(d);
  ASSERT_FALSE(valve);
  EXPECT_EQ(valve.errors()[0].path, "/tips_mm");
  EXPECT_EQ(valve.errors()[0].code, ErrorCode::MissingField);
}

}  // namespace
}  // namespace coapt
