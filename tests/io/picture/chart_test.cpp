#include "io/picture/chart.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "io/picture/line_chart.h"
#include "tests/io/picture/markup.h"

namespace coapt {
namespace {

TEST(Chart, AxesEndAtRoundNumbersAndTheLineRunsFromEndToEnd) {
  const std::string svg = chart_svg({"t", "x", "y", {{"s", {0.0, 50.0, 100.0}, {0.0, 4.0, 10.0}}}});
  EXPECT_EQ(count(svg, ">100</text>"), 1u);
  EXPECT_EQ(count(svg, ">10</text>"), 1u);
  // The plot area is 60..744 by 70..324 pixels: (0, 0) lower left, (50, 4) half way and four tenths
  // up.
  EXPECT_NE(svg.find("d=\"M60.0 324.0L402.0 222.4L744.0 70.0\""), std::string::npos);
  EXPECT_EQ(count(svg, "<circle"), 3u);
}

TEST(Chart, DecadesAreEvenlySpacedAndMarkersCanStandAlone) {
  Chart chart{"t", "x", "y", {{"s", {1.0, 10.0, 100.0}, {0.0, 4.0, 10.0}, false}}, true};
  const std::string svg = chart_svg(chart);
  for (const char* decade : {">1</text>", ">10</text>", ">100</text>"})
    EXPECT_GE(count(svg, decade), 1u) << decade;
  EXPECT_EQ(count(svg, "<path"), 0u);
  EXPECT_NE(svg.find("cx=\"397.0\" cy=\"222.4\""), std::string::npos);
}

TEST(LineChart, AShiftedSeriesStandsThatFarToTheRight) {
  PanelSeries series{.label = "s", .x = {0.0, 1.0}, .y = {0.0, 1.0}};
  const auto starts_px = [&] {
    const std::string svg =
        draw_line_panel({.words = {}, .series = {series}}, {0.0, 0.0, 400.0, 300.0});
    return std::stod(svg.substr(svg.find(" d=\"M") + 5));
  };
  const double before_px = starts_px();
  series.shift_px = 5.0;
  EXPECT_NEAR(starts_px(), before_px + 5.0, 0.11) << "to a tenth";
}

TEST(Chart, LegendGoesOnInAnotherLineWhereItWouldLeaveThePicture) {
  Chart chart;
  for (int i = 0; i < 5; ++i)
    chart.series.push_back(
        {"a label of thirty characters " + std::to_string(i), {0.0, 1.0}, {0.0, 1.0}});
  const std::string svg = chart_svg(chart);
  EXPECT_NE(svg.find("x1=\"12.0\" y1=\"48.0\""), std::string::npos);
  EXPECT_NE(svg.find("x1=\"12.0\" y1=\"67.0\""), std::string::npos);
}

TEST(Chart, SeveralSeriesHaveALegendAndOneHasNone) {
  const Series series{"label of a series", {0.0, 1.0}, {0.0, 1.0}};
  const Series other{"label of another", {0.0, 1.0}, {0.0, 1.0}};
  EXPECT_EQ(count(chart_svg({"t", "x", "y", {series}}), "label of a series"), 0u);
  const std::string svg = chart_svg({"t", "x", "y", {series, other}});
  EXPECT_EQ(count(svg, "label of a series"), 1u);
  EXPECT_EQ(count(svg, "label of another"), 1u);
}

TEST(Chart, ValuesThatAreNotFiniteBreakTheLineOnly) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::string svg =
      chart_svg({"t", "x", "y", {{"s", {0.0, 1.0, 2.0, 3.0}, {1.0, nan, 2.0, 3.0}}}});
  EXPECT_EQ(count(svg, "nan") + count(svg, "inf"), 0u);
  EXPECT_EQ(count(svg, "<circle"), 3u);
  const std::string path = svg.substr(svg.find(" d=\""));
  EXPECT_EQ(count(path, "M"), 2u);
}

TEST(Chart, NothingAndAConstantCanBeDrawn) {
  for (const Chart& chart : {Chart{"t", "x", "y", {}}, Chart{"t", "x", "y", {{"s", {}, {}}}},
                             Chart{"t", "x", "y", {{"s", {1.0, 2.0}, {7.0, 7.0}}}}}) {
    const std::string svg = chart_svg(chart);
    EXPECT_EQ(count(svg, "nan") + count(svg, "n/a"), 0u);
    EXPECT_EQ(count(svg, "</svg>"), 1u);
  }
}

TEST(Chart, LabelsAreEscaped) {
  const std::string hostile = "</text><script>alert(1)</script>";
  const std::string svg = chart_svg(
      {hostile, hostile, hostile, {{hostile, {0, 1}, {0, 1}}, {hostile, {0, 1}, {1, 0}}}});
  EXPECT_EQ(count(svg, "<script>"), 0u);
  EXPECT_GE(count(svg, "&lt;script&gt;"), 5u);
}

TEST(Chart, IsTheSameEveryTime) {
  const Chart chart{"t", "x", "y", {{"s", {0.0, 1.0 / 3.0, 1.0}, {0.1, 0.7, 0.2}}}};
  EXPECT_EQ(chart_svg(chart), chart_svg(chart));
}

}  // namespace
}  // namespace coapt
