#include "search/warnings.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/repair/apply_plan.h"
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
  return closure_warnings(plan, before);
}

std::vector<std::string> warnings(const RepairStep& step, const Valve& valve = small_valve()) {
  const RepairPlan plan = {{step}};
  const Expected<Valve> repaired = apply_plan(valve, plan, kCatalogue);
  EXPECT_TRUE(repaired);
  return operation_warnings({plan, valve, *repaired, kCatalogue});
}

/// @param about a plan or a step.
template <class About>
void expect_one(const About& about, const std::string& part) {
  const std::vector<std::string> lines = warnings(about);
  ASSERT_EQ(lines.size(), 1u) << part;
  EXPECT_NE(lines[0].find(part), std::string::npos) << lines[0];
}

bool any(const std::vector<std::string>& lines, const std::string& part) {
  return std::any_of(lines.begin(), lines.end(), [&part](const std::string& line) {
    return line.find(part) != std::string::npos;
  });
}

RepairStep own_ring(int sizes_below) {
  return Annuloplasty{.shape = "own", .sizes_below = sizes_below};
}
RepairStep ring(double size_mm) { return Annuloplasty{.shape = "d", .size_mm = size_mm}; }

TEST(Warnings, NoneForAQuietPlan) {
  EXPECT_TRUE(warnings(quiet()).empty());
  EXPECT_TRUE(warnings(own_ring(2)).empty());
  EXPECT_TRUE(warnings(Neochorda{"AL1", {Leaflet::Posterior, 0.4, 1.0}, 20.0}).empty());
}

TEST(Warnings, OfRings) {
  // The annulus is 36 mm wide.
  expect_one(ring(38.0), "stretch");
  EXPECT_TRUE(warnings(ring(36.0)).empty());
  EXPECT_TRUE(any(warnings(ring(26.0)), "stenosis"));
  EXPECT_TRUE(any(warnings(own_ring(5)), "stenosis"));
  EXPECT_FALSE(any(warnings(own_ring(4)), "4 ring sizes"));
  EXPECT_TRUE(any(warnings(own_ring(5)), "4 ring sizes"));
  EXPECT_TRUE(any(warnings(ring(26.0)), "4 ring sizes"));
}

TEST(Warnings, OfNeochordaeAndSutures) {
  expect_one(RepairStep(Neochorda{"AL1", {Leaflet::Posterior, 0.6, 1.0}, 20.0}), "other half");
  expect_one(RepairStep(Neochorda{"PM1", {Leaflet::Anterior, 0.6, 1.0}, 31.0}), "10 to 30");
  // The anterolateral tip is 28 mm from its trigone and 31 mm from mid-posterior.
  const auto suture = [](Anchor anchor, double length) {
    return RepairStep(PapillaryApproximation{
        .anchor = anchor, .annulus_around = 0.75, .suture_length_mm = length});
  };
  expect_one(suture(Anchor::AnnulusPoint, 25.0), "filling");
  expect_one(suture(Anchor::IpsilateralTrigone, 17.0), "unusual");
  Valve deep = small_valve();
  deep.heads[0].tip_mm.z() -= 10.0;
  EXPECT_TRUE(any(warnings(suture(Anchor::IpsilateralTrigone, 20.0), deep), "rejected"));
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
