#include "search/plans/verdict.h"

#include <gtest/gtest.h>

namespace coapt {
namespace {

RankedPlan plan_of(int rank, const RepairPlan& plan, int of_class = 1) {
  RankedPlan ranked;
  ranked.rank = rank;
  ranked.plan = plan;
  ranked.of_class = of_class;
  ranked.region.closures = 17;
  ranked.acceptable_probability = 0.97;
  ranked.is_acceptable = true;
  ranked.tier = PlanTier::Acceptable;
  ranked.model = ModelSpread{.draws = 8};
  return ranked;
}

const RepairPlan kRing{{Annuloplasty{CatalogueRing{"generic-classic", 32.0}}}};

TEST(Verdict, SaysThatNoOperationIsNeeded) {
  EXPECT_EQ(verdict_of({plan_of(1, {})}),
            "Without repair the valve leaks less than 5 mm² with a probability of 97.0 %, given "
            "the errors "
            "of tissue and mesh; no repair is needed.");
  EXPECT_EQ(verdict_of({}), "");
}

TEST(Verdict, SaysWhichPlansCannotBeToldApart) {
  EXPECT_EQ(
      verdict_of({plan_of(1, kRing), plan_of(2, kRing, 2)}),
      "Plan 1 leaks less than 5 mm² with a probability of 97.0 %, given the errors of execution, "
      "tissue and mesh.");
  EXPECT_EQ(verdict_of({plan_of(1, kRing), plan_of(2, kRing)}).find("Plans 1 and 2 are equivalent"),
            0u);
  EXPECT_EQ(verdict_of({plan_of(1, kRing), plan_of(2, kRing), plan_of(3, kRing)})
                .find("Plans 1 to 3 are equivalent"),
            0u);
}

TEST(Verdict, NamesTheErrorsThatAreKnown) {
  RankedPlan plan = plan_of(1, kRing);
  plan.model.reset();
  EXPECT_NE(verdict_of({plan}).find("given the errors of execution and mesh."), std::string::npos);
}

TEST(Verdict, SaysWhatTheOtherAnchorWouldChange) {
  RankedPlan plan = plan_of(1, kRing);
  EXPECT_EQ(verdict_of({plan}).find("anchor"), std::string::npos);
  const auto said = [&](double more_mm2) {
    plan.other_anchors = {
        {Side::Posteromedial, Anchor::IpsilateralTrigone, Anchor::SaddlePeak, more_mm2}};
    return verdict_of({plan});
  };
  const std::string trigone =
      " The posteromedial papillary muscle is anchored to the trigone; anchoring it to the saddle "
      "peak ";
  for (const auto& [more_mm2, words] :
       {std::pair<double, const char*>{0.0, "changes the mean leak by less than 0.1 mm²"},
        {-0.07, "changes the mean leak by less than 0.1 mm²"},
        {0.31, "changes the mean leak by less than 0.4 mm²"},
        {2.26, "raises the mean leak by 2.3 mm²"},
        {-3.0, "lowers the mean leak by 3.0 mm²"}})
    EXPECT_TRUE(said(more_mm2).ends_with(trigone + words + ", with errors of execution."))
        << said(more_mm2);
}

TEST(Verdict, CallsAPlanThatHangsOnThresholdsAChoice) {
  RankedPlan first = plan_of(1, kRing), other = plan_of(3, kRing);
  first.times_first = 18;
  other.times_first = 9;
  const std::string said = verdict_of({first, plan_of(2, kRing), other});
  EXPECT_NE(said.find("plan 1 ranks first in 18 of 27 settings, plan 3 in 9."), std::string::npos)
      << said;
  first.times_first = 17;
  const std::string more = verdict_of({first, plan_of(2, kRing), other});
  EXPECT_NE(more.find("17 of 27 settings, plan 3 in 9, unlisted plans in 1."), std::string::npos)
      << more;
  first.times_first = 26;
  EXPECT_NE(verdict_of({first}).find("26 of 27 settings, unlisted plans in 1."), std::string::npos);
  first.times_first = 27;
  other.times_first = 0;
  EXPECT_EQ(verdict_of({first, other}).find("thresholds"), std::string::npos);
}

TEST(Verdict, SaysThatNoPlanIsAcceptable) {
  RankedPlan bad = plan_of(1, kRing);
  bad.is_acceptable = false;
  bad.tier = PlanTier::NotAcceptable;
  bad.acceptable_probability = 0.4;
  EXPECT_EQ(verdict_of({bad}),
            "No plan is acceptable; plan 1 is not, because it leaks less than 5 mm² "
            "with a probability of 40 %, below the 95 % required.");
  bad.acceptable_probability = 0.999;
  bad.opening.emplace();
  bad.opening->measure.opening_area_mm2 = 300.0;
  bad.opening->measure.gradient_mmhg = 5.04;
  EXPECT_EQ(why_not_acceptable(bad), "its mean gradient at rest is 5.04 mmHg, above 5 mmHg");
  bad.opening->two_orifices = true;
  EXPECT_EQ(why_not_acceptable(bad).find("gradient"), std::string::npos) << "it is not known";
  bad.opening->measure.gradient_mmhg = 4.0;
  bad.fine_levels = 1;
  EXPECT_EQ(why_not_acceptable(bad),
            "it was not closed on the finer mesh or with all errors that were requested");
  bad.fine.emplace();
  bad.fine->leak_mm2 = 7.2;
  EXPECT_EQ(why_not_acceptable(bad), "on the finer mesh it leaks 7.2 mm²");
  bad.tier = PlanTier::Stenotic;
  EXPECT_EQ(why_not_acceptable(bad), "it opens to less than 1.5 cm²");
  bad.region.closures = 1;
  EXPECT_EQ(verdict_of({bad}).find("It is unknown"), 0u);
}

}  // namespace
}  // namespace coapt
