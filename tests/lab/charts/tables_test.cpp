#include "lab/charts/tables.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace coapt {
namespace {

AblationOutcome outcome(const char* change, double leak_mm2) {
  AblationOutcome outcome;
  outcome.group = "tissue";
  outcome.change = change;
  outcome.scene = "s";
  outcome.status = ClosureStatus::Converged;
  outcome.attempts = 2;
  outcome.compared = true;
  outcome.full_leak_mm2 = 8.0;
  outcome.leak_change_mm2 = leak_mm2;
  outcome.rms_mm = 0.5;
  outcome.seconds = 0.01;
  outcome.time_ratio = 2.0;
  return outcome;
}

TEST(AblationTable, HasTheColumnsThatScriptsRelyOnAndOneLineAnOutcome) {
  const std::string csv = ablation_csv({outcome("a", -3.0), outcome("b", 1.5)});
  EXPECT_EQ(csv.substr(0, csv.find('\n')),
            "group,change,scene,status,crossing,attempts,compared,full_leak_mm2,"
            "leak_change_mm2,rms_mm,seconds,time_ratio");
  EXPECT_NE(csv.find("tissue,a,s,converged,false,2,true,8,-3,0.5,0.01,2\n"), std::string::npos);
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 3);
}

AccuracyPoint point(double seconds, double rms_mm) {
  AccuracyPoint point;
  point.scene = "s";
  point.of = {Method::Fast, Membrane::Springs, 650, 0.01};
  point.triangles = 648;
  point.status = ClosureStatus::Converged;
  point.seconds = seconds;
  point.rms_mm = rms_mm;
  point.leak_error_mm2 = -rms_mm;
  return point;
}

TEST(AccuracyTable, HasTheColumnsThatScriptsRelyOnAndOneLineAPoint) {
  const std::string csv = accuracy_csv({point(0.01, 0.5), point(0.1, 0.25)});
  EXPECT_EQ(csv.substr(0, csv.find('\n')),
            "scene,method,membrane,triangles,tolerance,status,crossing,seconds,rms_mm,max_mm,"
            "leak_error_mm2,own_rms_mm,own_leak_error_mm2");
  EXPECT_NE(csv.find("s,fast,springs,648,0.01,converged,false,0.01,0.5,0,-0.5,0,0\n"),
            std::string::npos);
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 3);
}

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

TEST(StabilityTable, HasTheColumnsThatScriptsRelyOnAndNothingForNoNumber) {
  StabilityCell lost = cell("m", 100.0, StabilityOutcome::BlowsUp);
  lost.residual = lost.from_reference_mm = lost.end_from_reference_mm = lost.leak_difference_mm2 =
      std::numeric_limits<double>::quiet_NaN();
  const std::string csv = stability_csv({cell("m", 16.0, StabilityOutcome::Settles), lost});
  EXPECT_EQ(csv.substr(0, csv.find('\n')),
            "scene,axis,level,nominal,method,outcome,steps,seconds,residual,crossing_pairs,"
            "attempts,from_reference_mm,end_from_reference_mm,leak_difference_mm2");
  EXPECT_NE(csv.find("s,pressure,16,true,m,settles,100,0.5,0.25,0,1,0,0,0\n"), std::string::npos);
  EXPECT_NE(csv.find("s,pressure,100,false,m,blows_up,100,0.5,,0,1,,,\n"), std::string::npos);
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 3);
}

}  // namespace
}  // namespace coapt
