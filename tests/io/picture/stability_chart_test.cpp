#include "io/picture/stability_chart.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "tests/io/picture/markup.h"

namespace coapt {
namespace {

StabilityCell cell(const std::string& method, double level, StabilityOutcome outcome) {
  StabilityCell cell;
  cell.scene = "s";
  cell.method = method;
  cell.axis = Difficulty::Pressure;
  cell.level = level;
  cell.nominal = level == 16.0;
  cell.outcome = outcome;
  cell.steps = 100;
  cell.seconds = 0.5;
  cell.residual = 0.25;
  return cell;
}

TEST(StabilityChart, TableHasTheColumnsThatScriptsRelyOnAndNothingForNoNumber) {
  StabilityCell lost = cell("m", 100.0, StabilityOutcome::BlowsUp);
  lost.residual = lost.from_reference_mm = lost.end_from_reference_mm =
      lost.orifice_difference_mm2 = std::numeric_limits<double>::quiet_NaN();
  const std::string csv = stability_csv({cell("m", 16.0, StabilityOutcome::Settles), lost});
  EXPECT_EQ(csv.substr(0, csv.find('\n')),
            "scene,axis,level,nominal,method,outcome,steps,seconds,residual,crossing_pairs,"
            "attempts,from_reference_mm,end_from_reference_mm,orifice_difference_mm2");
  EXPECT_NE(csv.find("s,pressure,16,true,m,settles,100,0.5,0.25,0,1,0,0,0\n"), std::string::npos);
  EXPECT_NE(csv.find("s,pressure,100,false,m,blows_up,100,0.5,,0,1,,,\n"), std::string::npos);
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 3);
}

TEST(StabilityChart, SaysEachOutcomeByALetterToo) {
  StabilityCell third = cell("ladder", 100.0, StabilityOutcome::Settles);
  third.attempts = 3;
  const std::string svg = stability_svg({cell("m", 16.0, StabilityOutcome::OtherEquilibrium),
                                         cell("m", 100.0, StabilityOutcome::Crosses), third});
  // One of each in the legend.
  EXPECT_EQ(count(svg, ">O<"), 2u);
  EXPECT_EQ(count(svg, ">X<"), 2u);
  EXPECT_EQ(count(svg, ">S<"), 1u);
  EXPECT_EQ(count(svg, ">S3<"), 1u);
  EXPECT_EQ(count(svg, "class=\"nominal\""), 1u);
  EXPECT_EQ(count(svg, ">ladder<"), 1u);
}

TEST(StabilityChart, DrawsAPanelForEachSceneAndAxis) {
  StabilityCell other = cell("m", 16.0, StabilityOutcome::Settles);
  other.scene = "t & u";
  const std::string svg = stability_svg({cell("m", 16.0, StabilityOutcome::Settles), other});
  EXPECT_EQ(count(svg, "pressure, kPa"), 2u);
  EXPECT_EQ(count(svg, ">t &amp; u<"), 1u);
}

}  // namespace
}  // namespace coapt
