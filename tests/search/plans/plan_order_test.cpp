#include "search/plans/plan_order.h"

#include <gtest/gtest.h>

namespace coapt {
namespace {

/// Acceptable, lasting and wide.
PlanMerits good() {
  PlanMerits plan;
  plan.acceptable_probability = 0.99;
  plan.durability_mm = 12.0;
  plan.gradient_mmhg = 2.0;
  plan.steps = 1;
  return plan;
}

template <class Change>
PlanMerits with(Change change) {
  PlanMerits plan = good();
  change(plan);
  return plan;
}

std::vector<int> indices(const std::vector<PlanMerits>& plans, bool by_price = false) {
  std::vector<int> found;
  for (const PlanPlace& place : order_of(plans, by_price)) found.push_back(place.index);
  return found;
}

std::vector<int> classes(const std::vector<PlanMerits>& plans) {
  std::vector<int> found;
  for (const PlanPlace& place : order_of(plans)) found.push_back(place.of_class);
  return found;
}

TEST(PlanOrder, WhatPracticeRejectsComesLast) {
  const std::vector<PlanMerits> plans = {
      with([](PlanMerits& plan) { plan.rejected = true; }),
      with([](PlanMerits& plan) { plan.trusted = false; }),
      with([](PlanMerits& plan) { plan.fails_often = true; }),
      with([](PlanMerits& plan) { plan.stenotic = true; }),
      with([](PlanMerits& plan) { plan.acceptable_probability = 0.94; }),
      with([](PlanMerits& plan) { plan.avoidable_warnings = 1; }),
      good()};
  EXPECT_EQ(indices(plans), (std::vector{6, 5, 4, 3, 2, 1, 0}));
  EXPECT_EQ(classes(plans), (std::vector{1, 2, 3, 4, 5, 6, 7}));
}

TEST(PlanOrder, ALeakOnTheFinerMeshIsNotAcceptable) {
  EXPECT_TRUE(is_acceptable(good()));
  EXPECT_FALSE(is_acceptable(with([](PlanMerits& plan) { plan.closes_finely = false; })));
  EXPECT_FALSE(is_acceptable(with([](PlanMerits& plan) { plan.varied = false; })));
}

TEST(PlanOrder, AGradientAboveFiveIsNotAcceptableAndAnUnknownOneRejectsNothing) {
  const auto of_gradient = [](double gradient_mmhg) {
    return with([=](PlanMerits& plan) { plan.gradient_mmhg = gradient_mmhg; });
  };
  EXPECT_TRUE(is_acceptable(of_gradient(5.0)));
  EXPECT_FALSE(is_acceptable(of_gradient(5.1)));
  EXPECT_EQ(tier_of(of_gradient(5.1)), PlanTier::NotAcceptable);
  EXPECT_TRUE(is_acceptable(of_gradient(std::numeric_limits<double>::quiet_NaN())));
}

TEST(PlanOrder, AClassIsHeadedByItsSimplestMember) {
  const std::vector<PlanMerits> plans = {
      with([](PlanMerits& plan) { plan.steps = 3; }),
      with([](PlanMerits& plan) { plan.steps = 2, plan.muscles = 1; }),
      with([](PlanMerits& plan) { plan.steps = 2, plan.sizes_below = 2.0; }),
      with([](PlanMerits& plan) { plan.steps = 2, plan.sizes_below = 1.0, plan.leak_mm2 = 2.4; }),
      with([](PlanMerits& plan) { plan.steps = 2, plan.sizes_below = 1.0, plan.leak_mm2 = 2.2; })};
  EXPECT_EQ(indices(plans), (std::vector{4, 3, 2, 1, 0}));
  EXPECT_EQ(classes(plans), (std::vector{1, 1, 1, 1, 1}));
}

TEST(PlanOrder, ATraceOfLeakDecidesNothingAndTissueIsKept) {
  const std::vector<PlanMerits> plans = {
      with([](PlanMerits& plan) { plan.resections = 1; }),
      with([](PlanMerits& plan) { plan.sizes_below = 1.0; }),
      with([](PlanMerits& plan) { plan.sizes_below = 0.4, plan.durability_mm -= 1.0; }),
      with([](PlanMerits& plan) { plan.leak_mm2 = 0.6; })};
  EXPECT_EQ(indices(plans), (std::vector{3, 2, 1, 0}));
}

TEST(PlanOrder, AFirstPlanThatHangsOnThresholdsIsFirstInSomeSettingsOnly) {
  const std::vector<PlanMerits> plans = {
      with([](PlanMerits& plan) { plan.steps = 2, plan.durability_mm = 6.0; }),
      with([](PlanMerits& plan) { plan.steps = 1, plan.durability_mm = 4.5; })};
  EXPECT_EQ(indices(plans), (std::vector{1, 0}));
  EXPECT_EQ(times_first(plans), (std::vector{9, 18})) << "within 3, 2 or 1 mm";
  EXPECT_EQ(times_first({good()}), (std::vector{27}));
  EXPECT_TRUE(times_first({}).empty());
}

TEST(PlanOrder, WhatLastsShorterOrOpensLessIsOfAnotherClassHoweverSimple) {
  const PlanMerits simple = good();
  const std::vector<PlanMerits> plans = {
      with([](PlanMerits& plan) { plan.durability_mm = 5.9; }), with([](PlanMerits& plan) {
        plan.steps = 3, plan.durability_mm = 8.0, plan.gradient_mmhg = 4.0;
      }),
      with([](PlanMerits& plan) { plan.durability_mm = 8.0, plan.gradient_mmhg = 4.5; }),
      with([](PlanMerits& plan) { plan.steps = 2, plan.durability_mm = 6.1; })};
  EXPECT_EQ(indices(plans), (std::vector{3, 2, 1, 0})) << "4.5 is within 1 mmHg of 4.0";
  EXPECT_EQ(classes(plans), (std::vector{1, 2, 2, 3}));
  EXPECT_EQ(classes({simple, with([](PlanMerits& plan) { plan.gradient_mmhg = 3.0; })}),
            (std::vector{1, 1}))
      << "what usual rings leave";
}

TEST(PlanOrder, WhatBearsTheDiseaseOnceMoreLastsLongEnough) {
  const std::vector<PlanMerits> plans = {
      with([](PlanMerits& plan) { plan.steps = 3; }),
      with([](PlanMerits& plan) { plan.durability_mm = 6.4; }),
      with([](PlanMerits& plan) { plan.steps = 2, plan.durability_mm = 6.6; })};
  EXPECT_EQ(indices(plans), (std::vector{2, 0, 1}));
  EXPECT_EQ(classes(plans), (std::vector{1, 1, 2}));
}

TEST(PlanOrder, WhatIsNotKnownDecidesNothing) {
  const double unknown = std::numeric_limits<double>::quiet_NaN();
  const std::vector<PlanMerits> plans = {
      with([&](PlanMerits& plan) {
        plan.steps = 2, plan.durability_mm = plan.gradient_mmhg = unknown;
      }),
      with([&](PlanMerits& plan) { plan.durability_mm = plan.gradient_mmhg = unknown; })};
  EXPECT_EQ(indices(plans), (std::vector{1, 0}));
  EXPECT_EQ(classes(plans), (std::vector{1, 1}));
  EXPECT_TRUE(order_of({}).empty());
}

TEST(PlanOrder, ByPriceAcceptablePlansComeByTheirCost) {
  const std::vector<PlanMerits> plans = {
      with([](PlanMerits& plan) { plan.cost = 3.0; }),
      with([](PlanMerits& plan) { plan.cost = 1.0, plan.avoidable_warnings = 2, plan.steps = 4; }),
      with([](PlanMerits& plan) { plan.cost = 0.0, plan.acceptable_probability = 0.5; }),
      with([](PlanMerits& plan) { plan.cost = 2.0; })};
  EXPECT_EQ(indices(plans, true), (std::vector{1, 3, 0, 2}));
}

}  // namespace
}  // namespace coapt
