#include "search/plans/plan_row.h"

#include <gtest/gtest.h>

namespace coapt {
namespace {

RankedPlan ring_and_suture() {
  RankedPlan plan;
  plan.plan.steps = {Annuloplasty{CatalogueRing{"generic-classic", 32.0}},
                     PapillaryApproximation{.side = Side::Posteromedial, .suture_length_mm = 25.0}};
  plan.measure.leak.area_mm2 = 0.2;
  plan.region.closures = 17;
  plan.region.leak_mm2.mean = 0.4;
  plan.region.leak_mm2.sd = 0.3;
  plan.acceptable_probability = 0.974;
  plan.effort.sizes_below = 0.52;
  return plan;
}

TEST(PlanRow, NamesWhatIsLeftByMeanAndSdOverTheErrorsOfExecution) {
  RankedPlan plan = ring_and_suture();
  EXPECT_EQ(row_of(plan).leak, "none or trace (97.4 %)");
  plan.region.leak_mm2.sd = 0.7;
  EXPECT_EQ(row_of(plan).leak, "mild (97.4 %)");
  plan.region.leak_mm2.mean = 12.0;
  EXPECT_EQ(row_of(plan).leak, "13 mm² (97.4 %)");
}

TEST(PlanRow, NamesTheLeakAsPlannedWithoutErrorsOfExecution) {
  RankedPlan plan = ring_and_suture();
  plan.region.closures = 1;
  EXPECT_EQ(row_of(plan).leak, "none or trace");
}

TEST(PlanRow, SaysWhatIsNotKnown) {
  const PlanRow row = row_of(ring_and_suture());
  EXPECT_EQ(row.reserve, "not known");
  EXPECT_EQ(row.opening, "not known");
}

TEST(PlanRow, PrintsTheReserveToItsDigitsAndAsABoundAtTheFurthestCourse) {
  RankedPlan plan = ring_and_suture();
  plan.durability = Durability{.expected_mm = 7.41};
  plan.estimates.durability_mm = {7.41, Interval{6.9, 7.9}};
  EXPECT_EQ(row_of(plan).reserve, "7.4 mm");
  plan.durability->expected_mm = kFurthestCourse_mm;
  EXPECT_EQ(row_of(plan).reserve, "≥ 12 mm");
}

TEST(PlanRow, CountsStepsMusclesAndSizes) {
  RankedPlan plan = ring_and_suture();
  EXPECT_EQ(row_of(plan).effort, "2 steps, 1 muscle, 0.5 sizes below");
  plan.effort.sizes_below = 0.04;
  plan.plan.steps.pop_back();
  EXPECT_EQ(row_of(plan).effort, "1 step");
  plan.plan.steps.clear();
  EXPECT_EQ(row_of(plan).effort, "none");
}

TEST(PlanRow, CellsThatAllShareStandOnce) {
  std::vector<PlanRow> rows = {{"mild (96.0 %)", "7 mm", "4.0 cm², 2.4 mmHg", "1 step"},
                               {"mild (96.0 %)", "7 mm", "3.0 cm², 3.4 mmHg", "1 step"}};
  const PlanRow shared = take_shared(rows);
  EXPECT_EQ(shared.leak, "mild (96.0 %)");
  EXPECT_EQ(shared.reserve, "7 mm");
  EXPECT_EQ(shared.opening, "");
  EXPECT_EQ(shared.effort, "1 step");
  EXPECT_EQ(words_of(shared),
            "residual leak (< 5 mm²): mild (96.0 %); reserve: 7 mm; effort: 1 step");
  EXPECT_EQ(rows[1].leak, "");
  EXPECT_EQ(rows[1].opening, "3.0 cm², 3.4 mmHg");
}

TEST(PlanRow, OneRowSharesNothing) {
  std::vector<PlanRow> rows = {{"mild (96.0 %)", "7 mm", "4.0 cm², 2.4 mmHg", "1 step"}};
  EXPECT_EQ(take_shared(rows).leak, "");
  EXPECT_EQ(rows[0].leak, "mild (96.0 %)");
}

}  // namespace
}  // namespace coapt
