#include "core/opened/opened_valve.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/repair/apply_plan.h"
#include "tests/scenes/small_preset.h"

namespace coapt {
namespace {

OpenedValve opened(const Valve& valve) {
  Expected<OpenedValve> open = open_valve(valve);
  EXPECT_TRUE(open);
  EXPECT_EQ(open->closure.status, ClosureStatus::Converged);
  EXPECT_FALSE(open->closure.crossing);
  return *std::move(open);
}

Valve ringed(const Valve& valve, double size_mm) {
  return *apply_plan(valve, {{Annuloplasty{CatalogueRing{"generic-classic", size_mm}}}});
}

TEST(MeanGradient, OfTwoSquareCentimetresIsWorkedOutByHand) {
  // 150.8 = 37.7 * 2 * 2; the pulse needs 2.28 times what its mean does.
  EXPECT_NEAR(mean_gradient_mmhg(200.0, 150.8), 4.0 * 2.280, 0.001);
  EXPECT_TRUE(std::isinf(mean_gradient_mmhg(0.0, 155.0)));
}

TEST(MeanGradient, BeforeAndAfterAClipIsThatOfPatients) {
  // Herrmann 2009, EuroIntervention 4:437; the spread before is assumed.
  EXPECT_NEAR(mean_gradient_mmhg(600.0, 155.0), 1.7, 0.9);
  EXPECT_NEAR(mean_gradient_mmhg(360.0, 155.0), 4.1, 2.2);
}

TEST(OpenValve, AHealthyValveOpensAsWideAsMeasured) {
  const OpeningMeasure measure = opened(small_preset("human-normal")).measure;
  EXPECT_NEAR(measure.projected_area_mm2, 470.0, 60.0);  // 4.7 +- 0.6 cm2, Kubota 2010
  EXPECT_GT(measure.opening_area_mm2, measure.projected_area_mm2);
  EXPECT_LT(measure.opening_area_mm2, measure.annulus_area_mm2);
  EXPECT_LT(measure.gradient_mmhg, 2.0);
  EXPECT_NEAR(measure.gradient_exercise_mmhg, 1.96 * measure.gradient_mmhg, 1e-9);
}

TEST(OpenValve, ASmallerRingOpensLessAndATetheredValveLessBehindTheSameRing) {
  const Valve &normal = small_preset("human-normal"), &tethered = small_preset("secondary-mr");
  double before = 0.0;
  for (const double size_mm : {24.0, 28.0, 32.0}) {
    const OpeningMeasure measure = opened(ringed(tethered, size_mm)).measure;
    EXPECT_GT(measure.projected_area_mm2, before) << size_mm;
    EXPECT_LT(measure.projected_area_mm2,
              opened(ringed(normal, size_mm)).measure.projected_area_mm2)
        << size_mm;
    before = measure.projected_area_mm2;
  }
}

TEST(OpenValve, AreasAtHalfAndDoubleTheFlowAreWithin15Percent) {
  for (const char* name : {"human-normal", "secondary-mr"}) {
    const Valve& valve = small_preset(name);
    const OpeningMeasure measure = opened(valve).measure;
    EXPECT_GT(measure.pressure_mmhg, 1.0);
    EXPECT_LT(measure.pressure_mmhg, 7.0);
    for (const double times : {0.5, 2.0}) {
      OpeningOptions options;
      options.flow_ml_s = times * measure.flow_ml_s;
      EXPECT_NEAR(open_valve(valve, options)->measure.projected_area_mm2,
                  measure.projected_area_mm2, 0.15 * measure.projected_area_mm2)
          << name << ' ' << times;
    }
  }
}

TEST(OpenValve, ASmallHeartHasASmallFlowWhateverItsRing) {
  const Valve &normal = small_preset("human-normal"), &small = small_preset("porcine-5");
  EXPECT_EQ(filling_flow_ml_s(small_preset("barlow")), 155.0);
  EXPECT_NEAR(filling_flow_ml_s(normal), 150.0, 2.0);  // of 712 mm2 in systole
  EXPECT_LT(filling_flow_ml_s(small), 80.0);
  EXPECT_EQ(filling_flow_ml_s(ringed(small, 24.0)), filling_flow_ml_s(small));
  EXPECT_LT(opened(small).measure.gradient_mmhg, 4.0);
}

TEST(OpenValve, AClipLeavesTwoOpeningsThatAreSmallerTogether) {
  const Valve& valve = small_preset("human-p2-prolapse");
  const Valve clipped = *apply_plan(valve, {{EdgeToEdge{EdgeDevice::Clip, 0.5, 6.0}}});
  const OpenedValve open = opened(clipped);
  EXPECT_LT(open.measure.projected_area_mm2, 0.8 * opened(valve).measure.projected_area_mm2);
  EXPECT_LT(open.measure.opening_area_mm2, 0.5 * opened(valve).measure.opening_area_mm2);
  EXPECT_GE(open.leak.openings.size(), 2U);
  EXPECT_NE(opening_warnings(open).front().find("ties carry"), std::string::npos);
}

TEST(OpenValve, AnAnnulusThatHealthyMotionDoesNotExplainIsSaid) {
  OpenedValve open = opened(small_preset("human-normal"));
  open.measure.annulus_area_mm2 = 860.0;
  EXPECT_TRUE(opening_warnings(open).empty());
  open.measure.annulus_area_mm2 = 1200.0;
  EXPECT_EQ(opening_warnings(open).front().substr(0, 22), "annulus of 12.0 cm2 in");
  open.valve.systole.annular_contraction = 0.06;
  EXPECT_TRUE(opening_warnings(open).empty());
}

TEST(OpenValve, WhatIsOutOfRangeIsNamed) {
  const Valve& valve = small_preset("human-normal");
  OpeningOptions options;
  options.pressure_mmhg = 0.5;
  options.flow_ml_s = std::nan("");
  options.exercise = 0.9;
  std::vector<std::string> paths;
  const Expected<OpenedValve> refused = open_valve(valve, options);
  for (const Error& error : refused.errors()) paths.push_back(error.path);
  EXPECT_EQ(paths, (std::vector<std::string>{"/pressure_mmhg", "/flow_ml_s", "/exercise"}));
}

}  // namespace
}  // namespace coapt
