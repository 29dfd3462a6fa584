#include "search/warnings.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/scenes/small_valve.h"

namespace coapt {
namespace {

const std::vector<RingShape> kCatalogue = {{"d", 0.75, 1.0, 0.0, ""}};

RankedPlan quiet() {
  RankedPlan plan;
  for (CoaptationSection& section : plan.measure.coaptation.sections) section.contact = true;
  return plan;
}

std::vector<std::string> warnings(const RankedPlan& plan) {
  Evaluation before;
  before.measure.tension_max_n = 1.0;
  return plan_warnings(plan, small_valve(), kCatalogue, before);
}

void expect_one(const RankedPlan& plan, const std::string& part) {
  const std::vector<std::string> lines = warnings(plan);
  ASSERT_EQ(lines.size(), 1u) << part;
  EXPECT_NE(lines[0].find(part), std::string::npos) << lines[0];
}

RankedPlan with_step(const RepairStep& step) {
  RankedPlan plan = quiet();
  plan.plan.steps = {step};
  return plan;
}

TEST(Warnings, NoneForAQuietPlan) {
  EXPECT_TRUE(warnings(quiet()).empty());
  EXPECT_TRUE(warnings(with_step(Annuloplasty{.shape = "own", .sizes_below = 2})).empty());
  EXPECT_TRUE(warnings(with_step(Neochorda{"AL1", {Leaflet::Posterior, 0.4, 1.0}, 20.0})).empty());
}

TEST(Warnings, OfRings) {
  // The annulus is 36 mm wide.
  expect_one(with_step(Annuloplasty{.shape = "d", .size_mm = 38.0}), "stretch");
  expect_one(with_step(Annuloplasty{.shape = "d", .size_mm = 26.0}), "stenosis");
  expect_one(with_step(Annuloplasty{.shape = "own", .sizes_below = 5}), "stenosis");
  RankedPlan small = quiet();
  small.ring_sizes_below = 4.1;
  expect_one(small, "4 ring sizes");
}

TEST(Warnings, OfNeochordaeAndSutures) {
  expect_one(with_step(Neochorda{"AL1", {Leaflet::Posterior, 0.6, 1.0}, 20.0}), "other half");
  expect_one(with_step(Neochorda{"PM1", {Leaflet::Anterior, 0.6, 1.0}, 31.0}), "10 to 30");
  expect_one(
      with_step(PapillaryApproximation{.anchor = Anchor::AnnulusPoint, .annulus_around = 0.75}),
      "filling");
  RankedPlan moved = quiet();
  moved.anterolateral_movement_mm = 11.0;
  expect_one(moved, "unusual");
  moved.anterolateral_movement_mm = 16.0;
  expect_one(moved, "rejected");
}

TEST(Warnings, OfClosures) {
  RankedPlan plan = quiet();
  plan.status = ClosureStatus::StepLimit;
  expect_one(plan, "rest");
  plan = quiet();
  plan.crossing = true;
  expect_one(plan, "through each other");
  plan = quiet();
  plan.measure.tension_max_n = 3.1;
  expect_one(plan, "threefold");
  plan = quiet();
  plan.measure.coaptation.sections[2].contact = false;
  expect_one(plan, "1 of 9");
  plan = quiet();
  plan.leak_mm2.worst = 5.1;
  expect_one(plan, "5 mm2");
  plan = quiet();
  plan.region_failures = 2;
  plan.region_closures = 17;
  expect_one(plan, "2 of 17");
  plan = quiet();
  plan.region_failures = plan.region_closures = 1;
  EXPECT_TRUE(warnings(plan).empty()) << "the plan's own closure is no region";
}

}  // namespace
}  // namespace coapt
