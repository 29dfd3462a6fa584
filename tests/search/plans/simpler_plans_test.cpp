#include "search/plans/simpler_plans.h"

#include <gtest/gtest.h>

#include "core/repair/apply_plan.h"
#include "core/repair/approximation.h"
#include "core/repair/limits.h"
#include "core/repair/ring_sizing.h"
#include "search/plans/plan_key.h"
#include "tests/scenes/small_preset.h"

namespace coapt {
namespace {

const Valve& functional() { return shared_preset("human-functional-mr", 200); }

RepairStep ring(double size_mm) { return Annuloplasty{CatalogueRing{"generic-classic", size_mm}}; }

RepairStep free_suture(double length_mm) {
  return PapillaryApproximation{.side = Side::Posteromedial,
                                .anchor = Anchor::AnnulusPoint,
                                .annulus_around = 0.05,
                                .suture_length_mm = length_mm};
}

TEST(SimplerPlans, ASmallRingGetsItsTrueSize) {
  const auto simpler = simpler_plans(functional(), {{ring(26.0)}}, {});
  ASSERT_EQ(simpler.size(), 1u);
  const auto& made = std::get<CatalogueRing>(std::get<Annuloplasty>(simpler[0].steps[0]).ring);
  EXPECT_EQ(made.size_mm, 30.0);
  EXPECT_LT(ring_sizes_below(functional(), *apply_plan(functional(), simpler[0])), 0.5);
  EXPECT_TRUE(simpler_plans(functional(), {{ring(30.0)}}, {}).empty());
  EXPECT_TRUE(simpler_plans(functional(), {{Annuloplasty{OwnRing{3}}}}, {}).empty());
}

TEST(SimplerPlans, SuturesAreLeftOutOneByOneAndTogether) {
  RepairPlan plan{{ring(30.0), free_suture(24.0)}};
  plan.steps.push_back(PapillaryApproximation{
      .side = Side::Anterolateral, .anchor = Anchor::IpsilateralTrigone, .suture_length_mm = 24.0});
  const auto simpler = simpler_plans(functional(), plan, {});
  const RepairStep shorter = Annuloplasty{CatalogueRing{"generic-etlogix-like", 30.0}};
  ASSERT_GE(simpler.size(), 7u);
  EXPECT_EQ(plan_key(simpler[0]), plan_key({{plan.steps[0], plan.steps[1]}}));
  EXPECT_EQ(plan_key({{simpler[1].steps[0]}}), plan_key({{shorter}}));
  EXPECT_EQ(suture_of(simpler[1], Side::Posteromedial)->anchor, Anchor::IpsilateralTrigone);
  EXPECT_EQ(plan_key(simpler[2]), plan_key({{plan.steps[0], plan.steps[2]}}));
  EXPECT_EQ(plan_key(simpler[3]), plan_key({{shorter, plan.steps[2]}}));
  EXPECT_EQ(plan_key(simpler[4]), plan_key({{plan.steps[0]}}));
  EXPECT_EQ(plan_key(simpler[5]), plan_key({{ring(28.0)}}));
  EXPECT_EQ(plan_key(simpler[6]), plan_key({{ring(26.0)}}));
  SearchRules rules;
  rules.forbidden = {"annuloplasty:generic-etlogix-like"};
  EXPECT_EQ(plan_key(simpler_plans(functional(), plan, rules)[1]), plan_key(simpler[2]));
  const auto small = simpler_plans(functional(), {{ring(24.0), free_suture(24.0)}}, {});
  EXPECT_EQ(plan_key(small[0]), plan_key({{ring(24.0)}}));
  EXPECT_NE(suture_of(small[1], Side::Posteromedial), nullptr) << "no ring is smaller";
  const auto alone = simpler_plans(functional(), {{free_suture(24.0)}}, {});
  for (const RepairPlan& version : alone) EXPECT_FALSE(version.steps.empty());
}

TEST(SimplerPlans, AFreePointBecomesTheTrigoneWithAsMuchMovement) {
  const RepairPlan plan{{ring(26.0), free_suture(24.0)}};
  const auto simpler = simpler_plans(functional(), plan, {});
  ASSERT_EQ(simpler.size(), 5u)
      << "without it, a smaller ring alone, the trigone, the true size, both";
  const auto tip = [](const RepairPlan& made) {
    return papillary_tip_mm(*apply_plan(functional(), made), Side::Posteromedial);
  };
  const Vec3 before = papillary_tip_mm(functional(), Side::Posteromedial);
  for (const std::size_t i : {2u, 4u}) {
    const PapillaryApproximation& suture = *suture_of(simpler[i], Side::Posteromedial);
    EXPECT_EQ(suture.anchor, Anchor::IpsilateralTrigone);
    EXPECT_LE((tip(simpler[i]) - before).norm(), kUsualMovement_mm + 1e-9);
    EXPECT_GT((tip(simpler[i]) - before).norm(), 3.0);
  }
}

TEST(SaferPlans, AreTheNextSizesThatTheAnnulusTakes) {
  const auto sizes = [](double size_mm) {
    std::vector<double> found;
    for (const RepairPlan& safer : safer_plans(functional(), {{ring(size_mm)}}, {}))
      found.push_back(std::get<CatalogueRing>(std::get<Annuloplasty>(safer.steps[0]).ring).size_mm);
    return found;
  };
  EXPECT_EQ(sizes(26.0), (std::vector{28.0, 30.0}));
  double widest_mm = 30.0;
  while (!is_too_wide(functional(), widest_mm + kRingSizeStep_mm)) widest_mm += kRingSizeStep_mm;
  EXPECT_EQ(sizes(widest_mm - kRingSizeStep_mm), (std::vector{widest_mm}));
  EXPECT_TRUE(sizes(widest_mm).empty());
  SearchRules rules;
  rules.fixed.steps = {ring(26.0)};
  EXPECT_TRUE(safer_plans(functional(), {{ring(26.0)}}, rules).empty());
}

TEST(SimplerPlans, WhatRulesFixOrForbidIsLeftAsItIs) {
  const RepairPlan plan{{ring(26.0), free_suture(24.0)}};
  SearchRules rules;
  rules.fixed.steps = {ring(26.0)};
  EXPECT_EQ(simpler_plans(functional(), plan, rules).size(), 2u);
  rules.forbidden = {"papillary_approximation:ipsilateral_trigone"};
  const auto simpler = simpler_plans(functional(), plan, rules);
  ASSERT_EQ(simpler.size(), 1u);
  EXPECT_EQ(plan_key(simpler[0]), plan_key({{ring(26.0)}}));
  rules.fixed.steps.push_back(plan.steps[1]);
  EXPECT_TRUE(simpler_plans(functional(), plan, rules).empty());
}

}  // namespace
}  // namespace coapt
