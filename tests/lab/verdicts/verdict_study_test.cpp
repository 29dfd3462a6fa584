#include "lab/verdicts/verdict_study.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include "core/presets/presets.h"
#include "core/repair/apply_plan.h"
#include "lab/verdicts/drawn_plans.h"
#include "search/plans/plan_key.h"

namespace coapt {
namespace {

JudgedPlan judged(bool held_out, double own_mm2, double fine_mm2, double reference_mm2) {
  JudgedPlan plan;
  plan.valve = held_out ? "b" : "a";
  plan.held_out = held_out;
  plan.own = {true, own_mm2};
  plan.fine = {true, fine_mm2};
  plan.reference = {true, reference_mm2};
  plan.ring = "own";
  return plan;
}

/// Valve a has two plans, valve b three, of which the last does not close on the reference mesh.
std::vector<JudgedPlan> five_plans() {
  std::vector<JudgedPlan> plans = {judged(false, 0.5, 2.0, 1.5), judged(false, 3.0, 3.0, 4.0),
                                   judged(true, 0.2, 0.4, 0.3), judged(true, 1.1, 0.9, 0.8),
                                   judged(true, 0.9, 0.95, 0.0)};
  plans.back().reference.trusted = false;
  int k = 0;
  for (JudgedPlan& plan : plans) plan.rank = plan.fine_rank = plan.reference_rank = ++k;
  return plans;
}

TEST(DrawnPlans, AreDistinctPossibleAndComeBackWithTheirSeed) {
  const Valve valve = *make_preset("human-functional-mr", 300);
  const std::vector<RepairPlan> plans = draw_plans(valve, 12, 3);
  ASSERT_EQ(plans.size(), 12u);
  std::set<std::string> keys;
  for (const RepairPlan& plan : plans) {
    EXPECT_TRUE(apply_plan(valve, plan));
    keys.insert(plan_key(plan));
  }
  EXPECT_EQ(keys.size(), 12u);
  EXPECT_EQ(plan_key(draw_plans(valve, 12, 3).back()), plan_key(plans.back()));
  EXPECT_NE(plan_key(draw_plans(valve, 12, 4).front()), plan_key(plans.front()));
}

TEST(VerdictStudy, CountsAPlanThatDoesNotCloseAsLeaking) {
  const std::vector<VerdictAgreement> agreements = verdict_agreements(five_plans());
  ASSERT_EQ(agreements.size(), 4u);
  const VerdictCount &own = agreements[0].count, &fine_held_out = agreements[3].count;
  EXPECT_EQ(own.plans, 5);
  EXPECT_EQ(own.agree, 2);
  EXPECT_EQ(own.false_competent, 2);
  EXPECT_EQ(own.false_leaks, 1);
  EXPECT_EQ(agreements[3].mesh + agreements[3].valves, "fineheld out");
  EXPECT_EQ(fine_held_out.plans, 3);
  EXPECT_EQ(fine_held_out.agree, 2);
  EXPECT_EQ(fine_held_out.false_competent, 1);
}

TEST(VerdictStudy, ComparesOrdersWithinEachValve) {
  const std::vector<OrderAgreement> orders = order_agreements(five_plans());
  ASSERT_EQ(orders.size(), 16u);
  EXPECT_EQ(orders[0].order + " by " + orders[0].reference + " of " + orders[0].valves,
            "own leak by leak of all");
  // Valve a: the pair agrees. Valve b: 0.2, 1.1, 0.9 against 0.3, 0.8, none: two of three agree.
  EXPECT_DOUBLE_EQ(orders[0].tau, (3.0 - 1.0) / 4.0);
  EXPECT_DOUBLE_EQ(orders[1].tau, 1.0);
  EXPECT_TRUE(std::isnan(orders[2].tau_apart)) << "ranks are no areas";
  EXPECT_EQ(orders[8].valves, "held out");
  EXPECT_DOUBLE_EQ(orders[8].tau, (2.0 - 1.0) / 3.0);
  EXPECT_DOUBLE_EQ(orders[8].spearman, 0.5);
}

TEST(VerdictTable, HasTheColumnsThatScriptsRelyOnAndNothingForNoNumber) {
  const std::string csv = verdicts_csv(five_plans());
  EXPECT_EQ(csv.substr(0, csv.find('\n')),
            "valve,held_out,plan,ring,sutures,neochordae,own_trusted,own_leak_mm2,fine_trusted,"
            "fine_leak_mm2,reference_trusted,reference_leak_mm2,rank,fine_rank,reference_rank,cost,"
            "reference_cost");
  EXPECT_NE(csv.find("a,false,0,own,0,0,true,0.5,true,2,true,1.5,1,1,1,0,0\n"), std::string::npos);
  EXPECT_NE(csv.find("b,true,0,own,0,0,true,0.9,true,0.95,false,,5,5,5,0,0\n"), std::string::npos);
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 6);
}

}  // namespace
}  // namespace coapt
