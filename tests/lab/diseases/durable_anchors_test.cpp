#include "lab/diseases/durable_anchors.h"

#include <gtest/gtest.h>

namespace coapt {
namespace {

DurableAnchor repair(int anatomy, Anchor anchor, double durability_mm, double movement_mm) {
  return {.anatomy = anatomy,
          .anchor = anchor,
          .limit_mm2 = 5.0,
          .repaired = true,
          .movement_mm = movement_mm,
          .durability_mm = durability_mm};
}

TEST(DurableAnchors, AnswersAreOfAnatomiesThatBothAnchorsRepairByHalves) {
  using enum Anchor;
  DurableAnchor beyond = repair(4, SaddlePeak, 9.0, 4.0);
  beyond.repaired = false;
  const std::vector<DurableAnchorAnswer> answers = durable_anchor_answers(
      {repair(0, IpsilateralTrigone, 6.0, 3.0), repair(0, SaddlePeak, 4.0, 2.0),
       repair(2, IpsilateralTrigone, 5.0, 3.0), repair(2, SaddlePeak, 5.05, 2.5),
       repair(4, IpsilateralTrigone, 8.0, 3.0), beyond,  //
       repair(1, IpsilateralTrigone, 3.0, 3.0), repair(1, SaddlePeak, 4.0, 3.0)});
  ASSERT_EQ(answers.size(), 2u);
  EXPECT_FALSE(answers[0].odd);
  EXPECT_EQ(answers[0].anatomies, 2);
  EXPECT_EQ(answers[0].trigone_longer, 1);
  EXPECT_EQ(answers[0].peak_longer, 0) << "0.05 mm is a tie";
  EXPECT_NEAR(answers[0].mean_mm, 0.975, 1e-12);
  EXPECT_NEAR(answers[0].movement_mm, 0.75, 1e-12);
  EXPECT_TRUE(answers[1].odd);
  EXPECT_EQ(answers[1].peak_longer, 1);
}

TEST(DurableAnchors, AMovedMuscleClosesTheValveAndATighterSutureAndTheSaddlePeakLastLonger) {
  const std::vector<DurableAnchor> repairs =
      study_durable_anchors({.anatomies = 4, .seed = 2, .threads = 2});
  ASSERT_FALSE(repairs.empty());
  double loose_mm = 0.0, tight_mm = 0.0;
  for (std::size_t i = 0; i + 1 < repairs.size(); i += 2) {
    const DurableAnchor &loose = repairs[i], &tight = repairs[i + 1];
    EXPECT_EQ(loose.anchor, tight.anchor);
    EXPECT_GT(loose.leak_before_mm2, 5.0);
    if (!loose.repaired || !tight.repaired) continue;
    EXPECT_LE(loose.leak_mm2, 5.0);
    EXPECT_LE(tight.leak_mm2, 1.0);
    EXPECT_GE(tight.movement_mm, loose.movement_mm);
    EXPECT_LE(tight.durability_mm, 12.0);
    loose_mm += loose.durability_mm;
    tight_mm += tight.durability_mm;
  }
  EXPECT_GT(tight_mm, loose_mm);
  // The finding of docs/researcher/studies.md, on few anatomies.
  double longer_mm = 0.0;
  for (const DurableAnchorAnswer& of : durable_anchor_answers(repairs))
    if (of.limit_mm2 == 1.0) longer_mm += of.anatomies * of.mean_mm;
  EXPECT_LT(longer_mm, 0.0) << "saddle peaks last longer than trigones";
}

TEST(DurableAnchors, TheTableHasARowForEachRepair) {
  EXPECT_EQ(
      durable_anchors_csv({repair(7, Anchor::SaddlePeak, 6.5, 3.5)}),
      "anatomy,displaced,ring,anchor,limit_mm2,repaired,leak_before_mm2,movement_mm,suture_mm,"
      "leak_mm2,durability_mm\n7,both,0,saddle peak,5,1,0,3.5,0,0,6.5\n");
}

}  // namespace
}  // namespace coapt
