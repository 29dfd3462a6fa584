#include "search/plans/disturbance_frame.h"

#include <gtest/gtest.h>

namespace coapt {
namespace {

constexpr Eigen::Index kPlace = 13;

/// By how much both tips and the annulus are off, in the axes of disturbances.
Eigen::VectorXd place(int disturbance) {
  const auto& [al, pm, remodelling, share, growth, sewing] = disturbances()[disturbance];
  EXPECT_EQ(sewing, SewingError{}) << "not spanned";
  Eigen::VectorXd all(kPlace);
  all << al.length_mm, al.outwards_deg, al.posterior_deg, pm.length_mm, pm.outwards_deg,
      pm.posterior_deg, remodelling, share * remodelling, growth;
  return all;
}

TEST(DisturbanceFrame, ReachesEachDisturbanceThatItPredicts) {
  for (int d = 0; d < kDisturbances; ++d) {
    if (predicted_from(d).empty()) continue;
    double sum = 0.0, squares = 0.0;
    Eigen::VectorXd reached = Eigen::VectorXd::Zero(kPlace);
    for (const auto& [part, share] : predicted_from(d)) {
      sum += share;
      squares += share * share;
      reached += share * place(part);
    }
    EXPECT_EQ(sum, 1.0) << d;
    EXPECT_LT((reached - place(d)).norm(), 1e-4) << d;
    EXPECT_LT(squares, 16.0) << d << ": scatter of its frame grows";
  }
}

TEST(DisturbanceFrame, TakesNodesOfLowerIndexInTheRegion) {
  for (int d = 0; d < kRegion.count; ++d)
    for (const FrameShare& part : predicted_from(d)) EXPECT_LT(part.disturbance, d);
}

TEST(DisturbanceFrame, IsPredictedItselfFromWhatIsClosedBefore) {
  EXPECT_EQ(frame_level(0), 0);
  EXPECT_TRUE(in_frame(0));
  for (int d = 1; d < kDisturbances; ++d) {
    EXPECT_GE(frame_level(d), 1);
    for (const FrameShare& part : predicted_from(d)) {
      EXPECT_LT(frame_level(part.disturbance), frame_level(d));
      EXPECT_TRUE(in_frame(part.disturbance));
    }
  }
}

TEST(DisturbanceFrame, TheSecondOfAPairIsTheFirstOnesOpposite) {
  const std::vector<FrameShare>& shares = predicted_from(2);
  ASSERT_EQ(shares.size(), 2u);
  EXPECT_EQ(shares[0].disturbance, 0);
  EXPECT_NEAR(shares[0].share, 2.0, 1e-9);
  EXPECT_EQ(shares[1].disturbance, 1);
  EXPECT_NEAR(shares[1].share, -1.0, 1e-9);
}

TEST(DisturbanceFrame, LeavesFewUnpredicted) {
  // Three of the region, an end of each axis of each slice, one node of the rays and of the courses each, all independent ones.
  int unpredicted = 0;
  for (int d = 1; d < kDisturbances; ++d) unpredicted += predicted_from(d).empty();
  EXPECT_EQ(unpredicted, 3 + 2 + 2 + 4 + 8 + kIndependent.count);
}

}  // namespace
}  // namespace coapt
