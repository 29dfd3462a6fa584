#include "core/repair/approximation.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/repair/apply_plan.h"
#include "tests/scenes/small_valve.h"

namespace coapt {
namespace {

constexpr Side kLateral = Side::Anterolateral;

// Anterolateral tip at (-12, -2, -26), saddle peak at (0, 14, 0): (12, 16, 26) apart.
const double kDistance_mm = std::sqrt(12.0 * 12.0 + 16.0 * 16.0 + 26.0 * 26.0);

PapillaryApproximation to_saddle(double length_mm) {
  return {.side = kLateral, .anchor = Anchor::SaddlePeak, .suture_length_mm = length_mm};
}

TEST(Approximation, TipEndsAtTheSuturesLengthOnTheLineToTheAnchor) {
  const Valve valve = *apply_plan(small_valve(), {{to_saddle(0.75 * kDistance_mm)}});
  // A quarter of the way.
  EXPECT_NEAR((valve.heads[0].tip_mm - Vec3(-9.0, 2.0, -19.5)).norm(), 0.0, 1e-12);
  EXPECT_EQ(valve.heads[0].rest_mm, small_valve().heads[0].rest_mm);
  EXPECT_EQ(valve.heads[1].tip_mm, small_valve().heads[1].tip_mm);
}

TEST(Approximation, AllHeadsOfTheMuscleMoveTogether) {
  Valve valve = small_valve();
  valve.heads.push_back({.id = "AL2",
                         .side = kLateral,
                         .rest_mm = Vec3(-16.0, -4.0, -28.0),
                         .tip_mm = Vec3(-16.0, -4.0, -28.0)});
  const Vec3 mean(-14.0, -3.0, -27.0);  // of both heads
  const double distance = (mean - Vec3(0.0, 14.0, 0.0)).norm();
  const Valve repaired = *apply_plan(valve, {{to_saddle(distance - 5.0)}});
  const Vec3 move = repaired.heads[0].tip_mm - valve.heads[0].tip_mm;
  EXPECT_NEAR(move.norm(), 5.0, 1e-12);
  EXPECT_NEAR((repaired.heads[2].tip_mm - valve.heads[2].tip_mm - move).norm(), 0.0, 1e-12);
  EXPECT_NEAR((papillary_tip_mm(repaired, kLateral) - Vec3(0.0, 14.0, 0.0)).norm(), distance - 5.0,
              1e-12);
}

TEST(Approximation, TheSutureOfASideIsFoundAmongTheStepsOfAPlan) {
  const RepairPlan plan{{Neochorda{}, to_saddle(20.0)}};
  ASSERT_NE(suture_of(plan, kLateral), nullptr);
  EXPECT_EQ(suture_of(plan, kLateral)->suture_length_mm, 20.0);
  EXPECT_EQ(suture_of(plan, Side::Posteromedial), nullptr);
  EXPECT_EQ(suture_of({}, kLateral), nullptr);
}

TEST(Approximation, AnchorsAreTheLandmarksOfTheSide) {
  const Valve valve = small_valve();
  const double h = std::sqrt(0.5);
  PapillaryApproximation step{.side = kLateral, .anchor = Anchor::IpsilateralTrigone};
  EXPECT_NEAR((anchor_mm(valve, step) - Vec3(-18.0 * h, 14.0 * h, 0.0)).norm(), 0.0, 1e-12);
  step.side = Side::Posteromedial;
  EXPECT_NEAR((anchor_mm(valve, step) - Vec3(18.0 * h, 14.0 * h, 0.0)).norm(), 0.0, 1e-12);
  step.anchor = Anchor::AnnulusPoint;
  step.annulus_around = 0.75;
  EXPECT_NEAR((anchor_mm(valve, step) - Vec3(0.0, -14.0, 0.0)).norm(), 0.0, 1e-12);
}

TEST(Approximation, TheAnchorIsWhereTheRingPutsIt) {
  // One size below: the trigone moves from (-18 h, 14 h) to 34/36 of the way from (0, 14).
  const double h = std::sqrt(0.5), factor = 34.0 / 36.0;
  const Vec3 trigone(-factor * 18.0 * h, 14.0 - factor * (14.0 - 14.0 * h), 0.0);
  const Valve valve = *apply_plan(
      small_valve(), {{PapillaryApproximation{.side = kLateral, .suture_length_mm = 22.0},
                       Annuloplasty{OwnRing{1}}}});
  EXPECT_NEAR((valve.heads[0].tip_mm - trigone).norm(), 22.0, 1e-12);
}

TEST(Approximation, AcceptsExactlyTheTautLengthsAboveHalfTheDistance) {
  EXPECT_TRUE(apply_plan(small_valve(), {{to_saddle(kDistance_mm)}}));
  EXPECT_TRUE(apply_plan(small_valve(), {{to_saddle(0.5 * kDistance_mm)}}));
  for (const double length : {kDistance_mm + 0.01, 0.5 * kDistance_mm - 0.01, 0.0, std::nan("")}) {
    const Expected<Valve> refused = apply_plan(small_valve(), {{to_saddle(length)}});
    ASSERT_FALSE(refused) << length;
    EXPECT_EQ(refused.errors()[0].code, ErrorCode::ImpossibleStep);
    EXPECT_EQ(refused.errors()[0].path, "/steps/0/suture_length_mm");
  }
  EXPECT_EQ(suture_range_mm(20.0).min, 12.0);
  EXPECT_EQ(suture_range_mm(30.0).min, 15.0);
  EXPECT_EQ(suture_range_mm(30.0).max, 30.0);
}

TEST(Approximation, ASlackSutureIsCalledSlack) {
  const Expected<Valve> refused = apply_plan(small_valve(), {{to_saddle(40.0)}});
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.errors()[0].message.find("slack"), std::string::npos);
}

TEST(Approximation, RefusesAnAnchorOffTheAnnulusAndASideWithoutHeads) {
  PapillaryApproximation step{
      .side = kLateral, .anchor = Anchor::AnnulusPoint, .annulus_around = 1.5};
  EXPECT_EQ(apply_plan(small_valve(), {{step}}).errors()[0].path, "/steps/0/annulus_around");
  Valve valve = small_valve();
  valve.heads[0].side = Side::Posteromedial;
  EXPECT_EQ(apply_plan(valve, {{to_saddle(25.0)}}).errors()[0].path, "/steps/0/side");
}

}  // namespace
}  // namespace coapt
