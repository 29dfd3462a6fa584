#include "io/json/plan_document.h"

#include <gtest/gtest.h>

#include "io/json/plan_json.h"

namespace coapt {
namespace {

const std::string kRing = R"({"schema": "coapt.plan/1", "steps": [
  {"step": "annuloplasty", "shape": "own", "sizes_below": 2}]})";

std::string only_problem(const std::string& text) {
  const Expected<std::vector<NamedPlan>> plans = read_plans(text);
  if (plans || plans.errors().size() != 1) return "not one problem";
  return plans.errors()[0].path + ": " + plans.errors()[0].message;
}

TEST(PlanDocument, IsAPlanAKeptOneOrAListOfThem) {
  const struct {
    std::string text;
    std::vector<std::string> names;
  } cases[] = {
      {kRing, {""}},
      {R"({"kept_plan": "0f", "name": "small ring", "valve": "human-normal", "plan": )" + kRing +
           "}",
       {"small ring"}},
      {R"({"plans": [{"name": "A", "valve": {}, "plan": )" + kRing + R"(}, {"plan": )" + kRing +
           "}]}",
       {"A", "plan 2"}},
      {R"({"schema": "coapt.plans/2", "plans": [{"rank": 1, "steps": [{}], "name": null, "plan": )" +
           kRing + "}]}",
       {"plan 1"}},
      {R"({"schema": "coapt.plans/1", "plans": [{"rank": 1, "steps": 1, "name": null, "plan": )" +
           kRing + "}]}",
       {"plan 1"}},
      {R"({"kept_plans": [{"name": "B", "plan": )" + kRing + "}]}", {"B"}},
      {R"({"plans": [)" + kRing + "]}", {"plan 1"}},
  };
  for (const auto& [text, names] : cases) {
    const Expected<std::vector<NamedPlan>> plans = read_plans(text);
    ASSERT_TRUE(plans) << text;
    ASSERT_EQ(plans->size(), names.size()) << text;
    for (std::size_t i = 0; i < names.size(); ++i) {
      EXPECT_EQ((*plans)[i].name, names[i]);
      EXPECT_EQ((*plans)[i].plan.steps.size(), 1u);
    }
  }
}

TEST(PlanDocument, SaysWhereItIsWrong) {
  EXPECT_EQ(only_problem(R"({"plans": []})"), "/plans: has no plan; at least one is needed");
  EXPECT_EQ(only_problem(R"({"plans": [{"plan": {"steps": [{"step": "ring"}]}}]})").substr(0, 26),
            "/plans/0/plan/steps/0/step");
  EXPECT_EQ(only_problem(R"({"plans": [{"name": "A"}]})"), "/plans/0/plan: is missing");
  EXPECT_EQ(only_problem(R"({"plans": [7]})").substr(0, 9), "/plans/0:");
  EXPECT_FALSE(read_plans("[]"));
  EXPECT_FALSE(read_plans("7"));
}

}  // namespace
}  // namespace coapt
