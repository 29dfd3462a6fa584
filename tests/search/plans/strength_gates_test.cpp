#include "search/plans/strength_gates.h"

#include <gtest/gtest.h>

namespace coapt {
namespace {

PlanRecord pulled_by(const RepairPlan& plan, double tension_n) {
  PlanRecord record;
  record.plan = plan;
  record.closures[0].tension_max_n = 1.0;
  record.closures[1].tension_max_n = tension_n;
  record.closures[2] = {.status = ClosureStatus::StepLimit, .tension_max_n = 99.0};
  return record;
}

const RepairPlan kNeochorda{{Neochorda{"PM1", {Leaflet::Posterior, 0.5, 0.9}, 22.0}}};

TEST(StrengthGates, ANeochordaThatBearsMoreThanKnotsDoIsWarnedOf) {
  const std::vector<Gate> holds = strength_gates(pulled_by(kNeochorda, 2.9));
  ASSERT_EQ(holds.size(), 2u);
  EXPECT_EQ(holds[0].rule, "neochorda_strength");
  EXPECT_EQ(holds[0].severity, GateSeverity::Pass);
  EXPECT_NE(holds[0].finding.find("in 2 closures, including disturbed ones, is 2.9 N"),
            std::string::npos)
      << holds[0].finding << ": a closure that failed says nothing";
  const std::vector<Gate> gives = strength_gates(pulled_by(kNeochorda, 3.5));
  EXPECT_EQ(gives[0].severity, GateSeverity::Warn);
  EXPECT_NE(gives[0].finding.find("maximum of 3.5 N, in 1 of 2"), std::string::npos)
      << gives[0].finding;
}

TEST(StrengthGates, ForcesOnTheSuturesOfARingAreNotAssessed) {
  const std::vector<Gate> none = strength_gates(pulled_by({}, 9.0));
  EXPECT_EQ(none[0].severity, GateSeverity::Pass) << "no neochorda";
  EXPECT_EQ(none[1].rule, "ring_sutures");
  EXPECT_EQ(none[1].severity, GateSeverity::Pass) << "no ring";
  const RepairPlan ring{{Annuloplasty{OwnRing{2}}}};
  EXPECT_EQ(strength_gates(pulled_by(ring, 1.0))[1].severity, GateSeverity::NotAssessed);
}

}  // namespace
}  // namespace coapt
