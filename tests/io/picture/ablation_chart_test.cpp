#include "io/picture/ablation_chart.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace coapt {
namespace {

AblationOutcome outcome(const char* change, double orifice_mm2) {
  AblationOutcome outcome;
  outcome.group = "tissue";
  outcome.change = change;
  outcome.scene = "s";
  outcome.status = ClosureStatus::Converged;
  outcome.attempts = 2;
  outcome.compared = true;
  outcome.full_orifice_mm2 = 8.0;
  outcome.orifice_change_mm2 = orifice_mm2;
  outcome.rms_mm = 0.5;
  outcome.seconds = 0.01;
  outcome.time_ratio = 2.0;
  return outcome;
}

TEST(AblationChart, TableHasTheColumnsThatScriptsRelyOnAndOneLineAnOutcome) {
  const std::string csv = ablation_csv({outcome("a", -3.0), outcome("b", 1.5)});
  EXPECT_EQ(csv.substr(0, csv.find('\n')),
            "group,change,scene,status,crossing,attempts,compared,full_orifice_mm2,"
            "orifice_change_mm2,leak_change_mm2,rms_mm,seconds,time_ratio");
  EXPECT_NE(csv.find("tissue,a,s,converged,false,2,true,8,-3,0,0.5,0.01,2\n"), std::string::npos);
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 3);
}

TEST(AblationChart, HasThreeBarsForEachChangeAndTheirFigures) {
  AblationOutcome failed = outcome("b", 0.0);
  failed.crossing = true;
  failed.compared = false;
  const std::string svg = ablation_svg({outcome("a < b", -3.0), outcome("b", 1.5), failed});
  std::size_t bars = 0;
  for (std::size_t at = svg.find("<rect"); at != std::string::npos; at = svg.find("<rect", at + 1))
    ++bars;
  EXPECT_EQ(bars, 6u);
  for (const char* text : {"a &lt; b", ">3.0<", ">1.5<", ">0.50<", ">2.0<", ">1 fail<", ">tissue<"})
    EXPECT_NE(svg.find(text), std::string::npos) << text;
  EXPECT_NE(ablation_svg({}).find("</svg>"), std::string::npos);
}

}  // namespace
}  // namespace coapt
