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
  return ranked;
}

RepairPlan sutured(Side side, Anchor anchor) {
  return {{PapillaryApproximation{.side = side, .anchor = anchor, .suture_length_mm = 26.0}}};
}

const RepairPlan kRing{{Annuloplasty{CatalogueRing{"generic-classic", 32.0}}}};

TEST(Verdict, SaysThatNoOperationIsNeeded) {
  EXPECT_EQ(
      verdict_of({plan_of(1, {})}),
      "As it is the valve leaks less than 5 mm² with a probability of 97.0 %, over what is not "
      "known of tissue and mesh: no operation is needed.");
  EXPECT_EQ(verdict_of({}), "");
}

TEST(Verdict, SaysWhichPlansCannotBeToldApart) {
  EXPECT_EQ(verdict_of({plan_of(1, kRing), plan_of(2, kRing, 2)}),
            "Plan 1 leaks less than 5 mm² with a probability of 97.0 %, over errors of the hand, "
            "tissue and mesh.");
  EXPECT_EQ(verdict_of({plan_of(1, kRing), plan_of(2, kRing)}).find("Plans 1 to 2 cannot"), 0u);
}

TEST(Verdict, NamesTheAnchorsOfTheFirstPlansClass) {
  const RepairPlan trigone = sutured(Side::Posteromedial, Anchor::IpsilateralTrigone);
  const RepairPlan peak = sutured(Side::Posteromedial, Anchor::SaddlePeak);
  const RepairPlan point = sutured(Side::Posteromedial, Anchor::AnnulusPoint);
  const auto ends_with = [](const std::string& text, const std::string& end) {
    return text.size() >= end.size() && text.substr(text.size() - end.size()) == end;
  };
  EXPECT_TRUE(ends_with(
      verdict_of({plan_of(1, trigone), plan_of(2, peak), plan_of(3, peak), plan_of(4, point)}),
      " Its anchor is the trigone; the saddle peak (plan 2) and a free point of the annulus (plan "
      "4) do as well."));
  EXPECT_TRUE(ends_with(verdict_of({plan_of(1, trigone), plan_of(2, peak)}),
                        "; the saddle peak (plan 2) does as well."));
  for (const RepairPlan& other : {trigone, sutured(Side::Anterolateral, Anchor::SaddlePeak), kRing})
    EXPECT_EQ(verdict_of({plan_of(1, trigone), plan_of(2, other)}).find("anchor"),
              std::string::npos);
  EXPECT_EQ(verdict_of({plan_of(1, trigone), plan_of(2, peak, 2)}).find("anchor"),
            std::string::npos);
}

TEST(Verdict, CallsAPlanThatHangsOnThresholdsAChoice) {
  RankedPlan first = plan_of(1, kRing), other = plan_of(3, sutured(Side::Posteromedial, {}));
  first.times_first = 18;
  other.times_first = 9;
  const std::string said = verdict_of({first, plan_of(2, kRing), other});
  EXPECT_NE(said.find("plan 1 does in 18 of 27 settings, plan 3 in 9. Take it as a choice."),
            std::string::npos)
      << said;
  first.times_first = 27;
  other.times_first = 0;
  EXPECT_EQ(verdict_of({first, other}).find("choice"), std::string::npos);
}

TEST(Verdict, SaysThatNoPlanIsAcceptable) {
  RankedPlan bad = plan_of(1, kRing);
  bad.is_acceptable = false;
  bad.acceptable_probability = 0.4;
  EXPECT_EQ(
      verdict_of({bad}),
      "No plan is acceptable: the first one leaks less than 5 mm² with a probability of 40 %.");
  bad.region.closures = 1;
  EXPECT_EQ(verdict_of({bad}).find("It is not known"), 0u);
}

}  // namespace
}  // namespace coapt
