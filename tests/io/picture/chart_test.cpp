#include <gtest/gtest.h>

#include <limits>

#include "io/picture/picture.h"
#include "tests/io/picture/markup.h"

namespace coapt {
namespace {

TEST(Chart, AxesEndAtRoundNumbersAndTheLineRunsFromEndToEnd) {
  const std::string svg = chart_svg({"t", "x", "y", {{"s", {0.0, 50.0, 100.0}, {0.0, 4.0, 10.0}}}});
  EXPECT_EQ(count(svg, ">100</text>"), 1u);
  EXPECT_EQ(count(svg, ">10</text>"), 1u);
  // The plot area is 72..740 by 74..340 pixels: (0, 0) lower left, (50, 4) half way and four tenths
  // up.
  EXPECT_NE(svg.find("d=\"M72.00 340.00L406.00 233.60L740.00 74.00\""), std::string::npos);
  EXPECT_EQ(count(svg, "<circle"), 3u);
}

TEST(Chart, DecadesAreEvenlySpacedAndMarkersCanStandAlone) {
  Chart chart{"t", "x", "y", {{"s", {1.0, 10.0, 100.0}, {0.0, 4.0, 10.0}, false}}, true};
  const std::string svg = chart_svg(chart);
  for (const char* decade : {">1</text>", ">10</text>", ">100</text>"})
    EXPECT_GE(count(svg, decade), 1u) << decade;
  EXPECT_EQ(count(svg, "<path"), 0u);
  EXPECT_NE(svg.find("<circle cx=\"406.00\" cy=\"233.60\""), std::string::npos);
}

TEST(Chart, LegendGoesOnInAnotherLineWhereItWouldLeaveThePicture) {
  Chart chart;
  for (int i = 0; i < 5; ++i)
    chart.series.push_back({"a label of twenty-six letters", {0.0, 1.0}, {0.0, 1.0}});
  const std::string svg = chart_svg(chart);
  EXPECT_NE(svg.find("x1=\"72.0\" y1=\"40.0\""), std::string::npos);
  EXPECT_NE(svg.find("x1=\"72.0\" y1=\"58.0\""), std::string::npos);
}

TEST(Chart, SeveralSeriesHaveALegendAndOneHasNone) {
  const Series series{"label of a series", {0.0, 1.0}, {0.0, 1.0}};
  EXPECT_EQ(count(chart_svg({"t", "x", "y", {series}}), "label of a series"), 0u);
  EXPECT_EQ(count(chart_svg({"t", "x", "y", {series, series}}), "label of a series"), 2u);
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
