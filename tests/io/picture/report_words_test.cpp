#include "io/picture/report_words.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/repair/apply_plan.h"
#include "core/repair/describe.h"
#include "tests/scenes/sheets.h"
#include "tests/scenes/small_valve.h"

namespace coapt {
namespace {

ClosedValve closed_small_valve() {
  const Valve valve = small_valve();
  const ClosureResult closure = closed_at_rest(valve);
  return {valve, closure, measure(valve, closure)};
}

RankedPlan plan_of(const ClosedValve& before, std::vector<RepairStep> steps) {
  RankedPlan plan;
  plan.rank = 1;
  plan.plan.steps = std::move(steps);
  plan.description = describe(before.valve, plan.plan);
  plan.measure = before.measure;
  return plan;
}

TEST(SurgicalWords, SayHowFarASutureMovesTheMuscleAndWhereTo) {
  const ClosedValve before = closed_small_valve();
  // From the tip (12, -2, -26) to the saddle peak (0, 14, 0) it is sqrt(1076) = 32.80 mm; half of it is
  // taken away: 6 mm to the other side, 8 forwards, 13 up.
  RankedPlan plan = plan_of(
      before, {PapillaryApproximation{Side::Posteromedial, Anchor::SaddlePeak, 0.25, 16.4013}});
  plan.effort.posteromedial_movement_mm = 16.4011;
  const std::vector<StepWords> words = surgical_words(before, plan);
  ASSERT_EQ(words.size(), 1u);
  EXPECT_EQ(
      words[0].step,
      "Posteromedial papillary muscle tied to the saddle peak (middle of the anterior annulus), "
      "suture 16.4 mm");
  EXPECT_EQ(
      words[0].detail,
      "Moves the muscle by 16.4 mm, from 32.8 to 16.4 mm from its anchor: 13.0 mm up towards the "
      "annulus, 8.0 mm anteriorly, 6.0 mm towards the other muscle.");
}

TEST(SurgicalWords, MirrorTheSidesAndNameTrigones) {
  const ClosedValve before = closed_small_valve();
  const RankedPlan plan = plan_of(
      before,
      {PapillaryApproximation{Side::Anterolateral, Anchor::SaddlePeak, 0.25, 16.5},
       PapillaryApproximation{Side::Posteromedial, Anchor::IpsilateralTrigone, 0.25, 20.0}});
  const std::vector<StepWords> words = surgical_words(before, plan);
  EXPECT_NE(words[0].detail.find("towards the other muscle"), std::string::npos);
  EXPECT_NE(words[1].step.find("tied to the posteromedial trigone, suture 20.0 mm"),
            std::string::npos);
}

TEST(SurgicalWords, SayWhereOnTheAnnulusAnAnchorLies) {
  const ClosedValve before = closed_small_valve();
  const RankedPlan plan = plan_of(
      before,
      {PapillaryApproximation{Side::Posteromedial, Anchor::AnnulusPoint, 0.25 + 0.25 * 0.4, 20.0}});
  EXPECT_NE(surgical_words(before, plan)[0].step.find(
                "the annulus, 40 % of the way from saddle peak to anterolateral commissure"),
            std::string::npos);
}

TEST(SurgicalWords, SayWhatARingTakesAway) {
  const ClosedValve before = closed_small_valve();  // 36 mm across, 28 front to back
  RankedPlan plan = plan_of(before, {Annuloplasty{CatalogueRing{"generic-classic", 32.0}}});
  plan.measure.annulus.al_pm_mm = 32.0;
  plan.measure.annulus.ap_mm = 24.0;
  plan.effort.sizes_below = 2.25;
  const StepWords words = surgical_words(before, plan)[0];
  EXPECT_EQ(words.step, "Annuloplasty ring, size 32 mm, shape generic-classic");
  EXPECT_NE(words.detail.find("Annulus from 36.0 × 28.0 to 32.0 × 24.0 mm"), std::string::npos)
      << words.detail;
  EXPECT_NE(words.detail.find("2.2 sizes of 2 mm below the true size of 25.9 mm"),
            std::string::npos)
      << words.detail;
}

TEST(SurgicalWords, SayFromWhichHeadToWhichPartOfTheLeafletANeochordaGoes) {
  const ClosedValve before = closed_small_valve();
  const RankedPlan plan = plan_of(before, {Neochorda{"PM1", {Leaflet::Posterior, 0.7, 1.0}, 20.0},
                                           Neochorda{"AL1", {Leaflet::Anterior, 0.3, 0.6}, 22.0}});
  const std::vector<StepWords> words = surgical_words(before, plan);
  EXPECT_EQ(
      words[0].step,
      "Neochorda of 20.0 mm from the posteromedial papillary muscle (head PM1) to the free edge of "
      "P2");
  EXPECT_EQ(
      words[1].step,
      "Neochorda of 22.0 mm from the anterolateral papillary muscle (head AL1) to the belly of A2, "
      "60 % of the way from annulus to free edge");
}

TEST(SurgicalWords, OfNothingDoneSayNoRepair) {
  EXPECT_EQ(surgical_words(closed_small_valve(), RankedPlan{})[0].step, "No repair");
  EXPECT_EQ(short_words(RankedPlan{}), "no repair");
}

TEST(SurgicalWords, OfAPlanThatTheValveDoesNotAllowStillSayWhatItIs) {
  const ClosedValve before = closed_small_valve();
  RankedPlan plan;
  plan.plan.steps = {Annuloplasty{CatalogueRing{"no such ring", 32.0}},
                     PapillaryApproximation{Side::Posteromedial, Anchor::SaddlePeak, 0.25, 99.0},
                     ChordalExcision{"none"}};
  const std::vector<StepWords> words = surgical_words(before, plan);
  ASSERT_EQ(words.size(), 3u);
  EXPECT_NE(words[0].step.find("no such ring"), std::string::npos);
  EXPECT_NE(words[1].step.find("suture 99.0 mm"), std::string::npos);
}

TEST(ShortWords, NameEveryKindOfStep) {
  RankedPlan plan;
  plan.plan.steps = {
      Annuloplasty{OwnRing{1}},
      Annuloplasty{CatalogueRing{"generic-classic", 30.0}},
      PapillaryApproximation{Side::Anterolateral, Anchor::IpsilateralTrigone, 0, 21.5},
      Neochorda{"AL1", {Leaflet::Posterior, 0.4, 1.0}, 20.0},
      ChordalLengthChange{"c1", -2.0},
      ChordalExcision{"c2"},
      ChordalTransfer{"c3", {}},
      EdgeToEdge{EdgeDevice::Stitch, 0.5, 5.0},
      LeafletResection{}};
  EXPECT_EQ(
      short_words(plan),
      "ring in the annulus's own shape, undersized by 1 size + ring generic-classic 30 + AL muscle "
      "to "
      "trigone, 21.5 mm + "
      "neochorda AL1 to posterior leaflet, 20.0 mm + c1 shortened + c2 cut + c3 transferred + "
      "edge-to-edge stitch, 5.0 mm + triangular resection of the posterior leaflet, 10.0 mm");
}

TEST(ValveWords, SayWhereItLeaksAndWhatIsRuptured) {
  ClosedValve before = closed_small_valve();
  before.valve.chordae[1].ruptured = true;
  before.measure.leak.area_mm2 = 30.0;
  before.measure.leak.openings.clear();
  for (const auto& [area_mm2, segments] :
       {std::pair<double, std::vector<Segment>>{15.0, {Segment::P3, Segment::A3}},
        {10.0, {Segment::P2}},
        {4.0, {Segment::A1}},
        {1.0, {Segment::A3}}})
    before.measure.leak.openings.push_back(
        {area_mm2, Vec3::Zero(), Vec3::UnitZ(), segments, 1.0, {}});
  before.measure.leak_error_mm2 = 0.4;
  const std::string words = valve_words(before);
  EXPECT_NE(
      words.find(
          "leaks through 30.0 ± 0.4 mm² (15.0 mm² at P3, A3, 10.0 mm² at P2, 4.0 mm² at A1, 1 "
          "smaller)"),
      std::string::npos)
      << words;
  EXPECT_NE(words.find("Annulus 36.0 mm transverse, 28.0 mm anteroposterior"), std::string::npos);
  EXPECT_NE(words.find(" Ruptured chordae: PM1-A2-strut-1."), std::string::npos);
}

TEST(ValveWords, OfAClosureThatFlewApartSayThatNothingIsKnown) {
  ClosedValve before = closed_small_valve();
  before.closure.closed_mm(3, 1) = std::numeric_limits<double>::infinity();
  before.measure = measure(before.valve, before.closure);
  const std::string words = valve_words(before);
  EXPECT_NE(words.find("leaks through n/a."), std::string::npos) << words;
  EXPECT_EQ(words.find("nan"), std::string::npos);
}

}  // namespace
}  // namespace coapt
