#include "core/repair/apply_plan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <set>

#include "core/valve/validate.h"
#include "tests/core/repair/moved_valve.h"
#include "tests/scenes/small_valve.h"

namespace coapt {
namespace {

RepairPlan full_plan() {
  return {{Annuloplasty{CatalogueRing{"generic-classic", 34.0}},
           PapillaryApproximation{.side = Side::Posteromedial, .suture_length_mm = 24.0},
           Neochorda{"AL1", {Leaflet::Posterior, 0.45, 1.0}, 21.0},
           Neochorda{"PM1", {Leaflet::Posterior, 0.55, 1.0}, 20.0},
           ChordalLengthChange{"AL1-P1-marginal-1", 1.0},
           ChordalTransfer{"PM1-A2-strut-1", {Leaflet::Anterior, 0.6, 0.8}}}};
}

void expect_same(const Valve& a, const Valve& b) {
  EXPECT_EQ(a.provenance, b.provenance);
  EXPECT_EQ(a.annulus_mm, b.annulus_mm);
  EXPECT_EQ(a.rest_mm, b.rest_mm);
  for (std::size_t h = 0; h < a.heads.size(); ++h) EXPECT_EQ(a.heads[h].tip_mm, b.heads[h].tip_mm);
  ASSERT_EQ(a.chordae.size(), b.chordae.size());
  for (std::size_t c = 0; c < a.chordae.size(); ++c) {
    EXPECT_EQ(a.chordae[c].id, b.chordae[c].id);
    EXPECT_EQ(a.chordae[c].head, b.chordae[c].head);
    EXPECT_EQ(a.chordae[c].ruptured, b.chordae[c].ruptured);
    for (std::size_t s = 0; s < a.chordae[c].segments.size(); ++s) {
      const ChordaSegment &p = a.chordae[c].segments[s], &q = b.chordae[c].segments[s];
      EXPECT_EQ(p.rest_length_mm, q.rest_length_mm);
      EXPECT_EQ(p.insertion.face, q.insertion.face);
      EXPECT_EQ(p.insertion.weights, q.insertion.weights);
      EXPECT_EQ(p.branch_point_mm, q.branch_point_mm);
    }
  }
}

TEST(ApplyPlan, TheOrderOfTheStepsDoesNotMatter) {
  const RepairPlan plan = full_plan();
  const Valve reference = *apply_plan(small_valve(), plan);
  std::vector<std::size_t> order(plan.steps.size());
  std::iota(order.begin(), order.end(), 0u);
  do {
    RepairPlan shuffled;
    for (const std::size_t i : order) shuffled.steps.push_back(plan.steps[i]);
    const Expected<Valve> valve = apply_plan(small_valve(), shuffled);
    ASSERT_TRUE(valve);
    expect_same(*valve, reference);
  } while (!HasFailure() && std::next_permutation(order.begin(), order.end()));
}

TEST(ApplyPlan, TheRepairedValveIsValidAndKeepsItsIndices) {
  const Valve before = small_valve();
  const Valve repaired = *apply_plan(before, full_plan());
  EXPECT_TRUE(validate(repaired).empty());
  EXPECT_EQ(repaired.faces, before.faces);
  EXPECT_EQ(repaired.annulus, before.annulus);
  for (std::size_t c = 0; c < before.chordae.size(); ++c)
    EXPECT_EQ(repaired.chordae[c].id, before.chordae[c].id);
}

TEST(ApplyPlan, AnEmptyPlanIsNoRepair) {
  expect_same(*apply_plan(small_valve(), {}), small_valve());
}

TEST(ApplyPlan, TheMirroredPlanOnTheMirroredValveIsTheMirrorImage) {
  const RepairPlan plan = full_plan();
  RepairPlan twin = plan;
  std::get<PapillaryApproximation>(twin.steps[1]).side = Side::Anterolateral;
  std::get<Neochorda>(twin.steps[2]).insertion.along = 0.55;
  std::get<Neochorda>(twin.steps[3]).insertion.along = 0.45;
  std::get<ChordalTransfer>(twin.steps[5]).insertion.along = 0.4;
  const Valve a = mirrored(*apply_plan(small_valve(), plan));
  const Valve b = *apply_plan(mirrored(small_valve()), twin);
  EXPECT_NEAR((a.annulus_mm - b.annulus_mm).norm(), 0.0, 1e-9);
  for (std::size_t h = 0; h < a.heads.size(); ++h)
    EXPECT_NEAR((a.heads[h].tip_mm - b.heads[h].tip_mm).norm(), 0.0, 1e-9);
  for (std::size_t c = 0; c < a.chordae.size(); ++c)
    for (std::size_t s = 0; s < a.chordae[c].segments.size(); ++s) {
      const ChordaSegment &p = a.chordae[c].segments[s], &q = b.chordae[c].segments[s];
      EXPECT_NEAR((p.branch_point_mm - q.branch_point_mm).norm(), 0.0, 1e-9);
      if (!p.inserts) continue;
      const Vec3 end = position(p.insertion, a.faces, a.rest_mm);
      EXPECT_NEAR((end - position(q.insertion, b.faces, b.rest_mm)).norm(), 0.0, 1e-9);
    }
}

TEST(ApplyPlan, CommutesWithRigidMotions) {
  const Motion motion{Eigen::AngleAxisd(0.3, Vec3(2.0, 1.0, -1.0).normalized()).toRotationMatrix(),
                      Vec3(-4.0, 2.0, 1.0)};
  const Valve a = moved(*apply_plan(small_valve(), full_plan()), motion);
  const Valve b = *apply_plan(moved(small_valve(), motion), full_plan());
  EXPECT_NEAR((a.annulus_mm - b.annulus_mm).norm(), 0.0, 1e-9);
  EXPECT_NEAR((a.heads[1].tip_mm - b.heads[1].tip_mm).norm(), 0.0, 1e-9);
  EXPECT_EQ(a.chordae[3].segments[0].insertion.face, b.chordae[3].segments[0].insertion.face);
}

TEST(ApplyPlan, RefusesStepsThatLeaveNoValidValve) {
  // A second head just below the annulus, which a suture of both would draw through it; a chorda of
  // 95 mm, which may be 100 mm long.
  Valve valve = small_valve();
  PapillaryHead high = valve.heads[1];
  high.id = "PM2";
  high.tip_mm = Vec3(12.0, -2.0, -2.0);
  valve.heads.push_back(high);
  valve.chordae[1].segments[0].rest_length_mm = 95.0;
  ASSERT_TRUE(validate(valve).empty());
  const PapillaryApproximation suture{.side = Side::Posteromedial, .suture_length_mm = 12.0};
  const RepairPlan plan{
      {ChordalExcision{"AL1-P1-marginal-1"}, ChordalLengthChange{"PM1-A2-strut-1", 6.0}, suture}};
  const Expected<Valve> refused = apply_plan(valve, plan);
  ASSERT_FALSE(refused);
  ASSERT_EQ(refused.errors().size(), 2u);
  EXPECT_EQ(refused.errors()[0].path, "/steps/2");
  EXPECT_EQ(refused.errors()[1].path, "/steps/1");
  for (const Error& error : refused.errors()) EXPECT_EQ(error.code, ErrorCode::ImpossibleStep);
  EXPECT_NE(refused.errors()[0].message.find("/papillary_heads/2/tip_mm/2"), std::string::npos);
}

TEST(ApplyPlan, ListsEveryImpossibleStep) {
  const RepairPlan plan{{
      Annuloplasty{OwnRing{1}},
      Annuloplasty{CatalogueRing{"generic-classic", 30.0}},
      PapillaryApproximation{.side = Side::Anterolateral, .suture_length_mm = 25.0},
      PapillaryApproximation{.side = Side::Anterolateral, .suture_length_mm = 24.0},
      PapillaryApproximation{.side = Side::Posteromedial, .suture_length_mm = 90.0},
      ChordalExcision{"AL1-P1-marginal-1"},
      ChordalLengthChange{"AL1-P1-marginal-1", 1.0},
      ChordalTransfer{"AL1-P1-marginal-1", {}},
      Neochorda{"AL9", {}, 50.0},
      ChordalExcision{"neochorda-1"},
  }};
  const Expected<Valve> refused = apply_plan(small_valve(), plan);
  ASSERT_FALSE(refused);
  std::multiset<std::string> paths;
  for (const Error& error : refused.errors()) paths.insert(error.path);
  const std::multiset<std::string> expected = {
      "/steps/1",        "/steps/3/side", "/steps/4/suture_length_mm", "/steps/6/chorda",
      "/steps/7/chorda", "/steps/8/head", "/steps/8/length_mm",        "/steps/9/chorda"};
  EXPECT_EQ(paths, expected);
}

}  // namespace
}  // namespace coapt
