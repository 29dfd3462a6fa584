#include "io/picture/accuracy_chart.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace coapt {
namespace {

AccuracyPoint point(double seconds, double rms_mm) {
  AccuracyPoint point;
  point.scene = "s";
  point.of = {Method::Fast, Membrane::Springs, 650, 0.01};
  point.triangles = 648;
  point.status = ClosureStatus::Converged;
  point.seconds = seconds;
  point.rms_mm = rms_mm;
  point.orifice_error_mm2 = -rms_mm;
  return point;
}

TEST(AccuracyChart, TableHasTheColumnsThatScriptsRelyOnAndOneLineAPoint) {
  const std::string csv = accuracy_csv({point(0.01, 0.5), point(0.1, 0.25)});
  EXPECT_EQ(csv.substr(0, csv.find('\n')),
            "scene,method,membrane,triangles,tolerance,status,crossing,seconds,rms_mm,max_mm,"
            "orifice_error_mm2,own_rms_mm,own_orifice_error_mm2");
  EXPECT_NE(csv.find("s,fast,springs,648,0.01,converged,false,0.01,0.5,0,-0.5,0,0\n"),
            std::string::npos);
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 3);
}

TEST(AccuracyChart, FrontPassesOverWhatIsBeatenAndWhatDidNotConverge) {
  AccuracyPoint crossed = point(0.001, 0.01);
  crossed.crossing = true;
  const std::string svg =
      accuracy_svg({point(0.01, 0.5), point(0.02, 0.6), point(0.1, 0.25), crossed});
  // Two points remain on the line.
  const std::size_t line = svg.rfind("<path class=\"line\"");
  const std::string path = svg.substr(line, svg.find("/>", line) - line);
  EXPECT_EQ(std::count(path.begin(), path.end(), 'L'), 1);
  EXPECT_NE(orifice_error_svg({point(0.01, 0.5)}).find("orifice"), std::string::npos);
}

}  // namespace
}  // namespace coapt
