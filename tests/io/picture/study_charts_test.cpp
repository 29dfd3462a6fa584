#include "io/picture/study_charts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "io/picture/displacement_charts.h"
#include "io/picture/oblique_plot.h"
#include "tests/io/picture/markup.h"

namespace coapt {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

AnnulusStudy annulus() {
  AnnulusStudy study;
  for (int d = 0; d <= 30; ++d) study.dilation_percent.push_back(d);
  for (const double height : {100.0, 75.0, 50.0, 25.0, 0.0}) {
    study.height_percent.push_back(height);
    study.area_mm2.emplace_back();
    for (const double d : study.dilation_percent)
      study.area_mm2.back().push_back(0.1 * d * d * (0.75 + 0.0025 * height));
  }
  return study;
}

DisplacementGrid grid(Displaced displaced, int nodes, double step_mm, int ring_sizes_below) {
  DisplacementGrid grid{displaced, ring_sizes_below, nodes, step_mm, {}};
  for (int t = 0; t < nodes; ++t)
    for (int p = 0; p < nodes; ++p)
      for (int a = 0; a < nodes; ++a) {
        const double tether = std::max(0.0, step_mm * (t + 0.5 * p + 2.0 * a) - ring_sizes_below);
        grid.area_mm2.push_back(0.5 * tether * tether);
      }
  return grid;
}

PapillaryStudy papillary() {
  PapillaryStudy study;
  for (std::size_t k = 0; k < kDisplaced.size(); ++k)
    study.grids[k] = grid(kDisplaced[k], 7, 1.0, 0);
  return study;
}

RingStudy ring() {
  RingStudy study;
  for (std::size_t k = 0; k < kDisplaced.size(); ++k)
    for (std::size_t sizes = 0; sizes <= 3; ++sizes)
      study.grids[k][sizes] = grid(kDisplaced[k], 4, 2.0, static_cast<int>(sizes));
  return study;
}

Approximation approximation(std::size_t anchor, double mean_mm2) {
  Approximation found;
  found.anchor = anchor;
  found.region.mean_mm2 = mean_mm2;
  found.region.sd_mm2 = 0.5;
  return found;
}

ApproximationStudy anchors() {
  ApproximationStudy study;
  study.anchors.resize(2);
  study.anchors[0].name = "trigone";
  study.anchors[1].name = "saddle peak";
  for (const double mean : {1.0, 2.0, 3.0})
    for (const std::size_t anchor : {0u, 1u})
      study.approximations.push_back(
          approximation(anchor, mean + 4.0 * static_cast<double>(anchor)));
  return study;
}

AnchorSummary summary(const std::string& name, double around, double mean_mm2) {
  AnchorSummary summary;
  summary.anchor.name = name;
  summary.anchor.around = around;
  summary.mean_mm2 = mean_mm2;
  return summary;
}

void expect_a_figure(const std::string& svg) {
  EXPECT_EQ(markup_error(svg), "");
  EXPECT_EQ(count(svg, "<svg"), 1u);
  for (const char* lost : {"nan", "n/a", ">-0<"}) EXPECT_EQ(count(svg, lost), 0u) << lost;
}

TEST(StudyCharts, AreWellFormedWithAndWithoutAnythingToDraw) {
  for (const std::string& svg :
       {annulus_svg(annulus(), true), annulus_svg({}, true), annulus_svg({}),
        papillary_svg(papillary()), papillary_svg({}), ring_svg(ring()), ring_svg({}),
        anchors_histogram_svg(anchors()), anchors_histogram_svg({}),
        anchor_scan_svg({summary("annulus", 0.0, 3.0)}, {summary("trigone", 0.0, 2.0)}),
        anchor_scan_svg({}, {summary("trigone", 0.0, 2.0)}), anchor_scan_svg({}, {})})
    expect_a_figure(svg);
}

TEST(StudyCharts, LeaveOutConfigurationsThatHaveNoOrifice) {
  AnnulusStudy broken = annulus();
  broken.area_mm2[0][0] = broken.area_mm2[1][7] = broken.area_mm2[4][30] = kNaN;
  expect_a_figure(annulus_svg(broken));
  PapillaryStudy lost = papillary();
  lost.grids[0].area_mm2[0] = lost.grids[2].area_mm2[170] = kNaN;
  expect_a_figure(papillary_svg(lost));
  for (double& area : lost.grids[1].area_mm2) area = kNaN;
  RingStudy rings = ring();
  for (DisplacementGrid& grid : rings.grids[1])
    for (double& area : grid.area_mm2) area = kNaN;
  expect_a_figure(ring_svg(rings));
  ApproximationStudy study = anchors();
  for (Approximation& found : study.approximations) found.region.mean_mm2 = kNaN;
  expect_a_figure(anchors_histogram_svg(study));
  expect_a_figure(anchor_scan_svg({summary("annulus", 0.0, kNaN), summary("annulus", 0.5, 1.0)},
                                  {summary("trigone", 0.0, kNaN)}));
}

TEST(StudyCharts, AnnulusHasALineForEachHeightAndTheThesisAsRings) {
  EXPECT_EQ(count(annulus_svg(annulus()), "<path class=\"line"), 2 * 5u);
  EXPECT_EQ(count(annulus_svg(annulus()), "class=\"hollow"), 0u);
  EXPECT_EQ(count(annulus_svg(annulus(), true), "class=\"hollow c-ink"), 4u);
}

TEST(StudyCharts, PapillaryHasFourSurfacesAndSixtyFourArrowsForEachClass) {
  const std::string svg = papillary_svg(papillary());
  EXPECT_EQ(count(svg, "<path class=\"face"), 3u * 4u * 36u);
  EXPECT_EQ(count(svg, "class=\"arrow"), 3u * 64u);
}

TEST(StudyCharts, SurfaceHasAHoleAroundANodeWithoutOrifice) {
  PapillaryStudy study = papillary();
  study.grids[0].area_mm2[(3 * 7 + 3) * 7 + 2] = kNaN;
  EXPECT_EQ(count(papillary_svg(study), "<path class=\"face"), 3u * 4u * 36u - 4u);
}

TEST(StudyCharts, RingShowsEachRatioOnceAndNoneWhereTheProperlySizedValveIsTight) {
  const std::string svg = ring_svg(ring());
  // t + p / 2 + 2 a in steps of 2 mm: the orifice is below 1 mm2 undisplaced and by 2 mm posteriorly.
  EXPECT_EQ(count(svg, "class=\"empty"), 9u * 2u);
  EXPECT_EQ(count(svg, "class=\"cell"), 9u * 62u);
  // Largest: (21 - sizes)^2 / 21^2.
  EXPECT_EQ(count(svg, "U1: largest 91 %"), 3u);
  EXPECT_EQ(count(svg, "U3: largest 73 %"), 3u);
}

TEST(StudyCharts, HistogramSaysMeanAndSdOfEachAnchor) {
  // 1, 2, 3: sd sqrt(2 / 3).
  const std::string svg = anchors_histogram_svg(anchors());
  EXPECT_EQ(count(svg, "trigone: 2.0 ± 0.8 mm²"), 1u);
  EXPECT_EQ(count(svg, "saddle peak: 6.0 ± 0.8 mm²"), 1u);
  EXPECT_EQ(count(svg, "trigone: 0.5 ± 0.0 mm²"), 1u) << "sd of the regions, second row";
}

TEST(StudyCharts, HistogramCountsWhatLiesBeyondItsLastBin) {
  ApproximationStudy study = anchors();
  study.approximations.clear();
  for (int i = 0; i < 99; ++i) study.approximations.push_back(approximation(0, 1.0 + 0.01 * i));
  study.approximations.push_back(approximation(0, 500.0));
  EXPECT_EQ(count(anchors_histogram_svg(study), "n 100, 1 beyond"), 1u);
}

TEST(StudyCharts, ScanMarksItsLeastPlaceAndLeavesOutAnotherProtocol) {
  AnchorSummary other = summary("annulus", 0.75, 1.0);
  other.protocol = Protocol::Optimum;
  const std::string svg =
      anchor_scan_svg({summary("annulus", 0.25, 4.0), summary("annulus", 0.5, 3.0), other},
                      {summary("trigone", 0.0, 5.0), summary("saddle peak", 0.25, 6.0)});
  EXPECT_EQ(count(svg, "minimum 3.0 at 0.50"), 1u);
  EXPECT_EQ(count(svg, "<path class=\"line dashed"), 2u * 2u);
  EXPECT_EQ(count(svg, "r=\"4.5\""), 2u * 1u) << "an anchor whose place is known";
}

TEST(StudyCharts, EscapeNamesOfAnchors) {
  ApproximationStudy study = anchors();
  study.anchors[0].name = "<b> & \"c\"";
  expect_a_figure(anchors_histogram_svg(study));
  expect_a_figure(anchor_scan_svg({}, {summary("<b> & \"c\"", 0.0, 2.0)}));
}

TEST(ChartFrame, AxesHaveRoundTicks) {
  const Axis axis = round_axis({3.0, 86.9});
  EXPECT_EQ(axis.low, 0.0);
  EXPECT_EQ(axis.high, 100.0);
  EXPECT_EQ(ticks_of(axis), (std::vector<double>{0.0, 20.0, 40.0, 60.0, 80.0, 100.0}));
  EXPECT_EQ(ticks_of({-0.5, 6.5, 2.0, 0}), (std::vector<double>{0.0, 2.0, 4.0, 6.0}));
  EXPECT_EQ(round_axis({}).high, 1.0) << "nothing to show";
  for (const double value : {-1e17, 0.0, 45.7, 1e17}) {
    const Axis around = round_axis({value, value});
    EXPECT_TRUE(around.low <= value && value <= around.high && around.low < around.high) << value;
  }
}

TEST(ObliquePlot, BoxStaysInItsAreaAndZGoesUp) {
  const ObliqueBox box{
      {Axis{0, 6, 2, 0}, Axis{0, 6, 2, 0}, Axis{0, 80, 20, 0}}, 1.2, {10, 20, 310, 320}};
  for (int corner = 0; corner < 8; ++corner) {
    const Eigen::Vector2d at =
        project(box, {corner & 1 ? 6.0 : 0.0, corner & 2 ? 6.0 : 0.0, corner & 4 ? 80.0 : 0.0});
    EXPECT_GE(at.x(), 10.0 - 1e-9);
    EXPECT_LE(at.x(), 310.0 + 1e-9);
    EXPECT_GE(at.y(), 20.0 - 1e-9);
    EXPECT_LE(at.y(), 320.0 + 1e-9);
  }
  const Eigen::Vector2d low = project(box, {3, 3, 10}), high = project(box, {3, 3, 70});
  EXPECT_NEAR(low.x(), high.x(), 1e-9);
  EXPECT_GT(low.y(), high.y());
}

}  // namespace
}  // namespace coapt
