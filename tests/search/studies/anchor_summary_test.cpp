#include "search/studies/anchor_summary.h"

#include <gtest/gtest.h>

#include <cmath>

namespace coapt {
namespace {

ApproximationStudy by_hand() {
  ApproximationStudy study;
  study.protocol = Protocol::Closed;
  study.anchors = {{"a", 0.1, {}}, {"b", 0.2, {}}};
  const auto add = [&](Displaced displaced, std::size_t anchor, double mean, bool repaired) {
    Approximation found;
    found.displaced = displaced;
    found.anchor = anchor;
    found.repaired = repaired;
    found.movement_mm = 2.0 * mean;
    found.suture_mm = 3.0 * mean;
    found.region = {mean,        0.5 * mean, 9.0,         0.25 * mean, 0.125 * mean,
                    0.75 * mean, -mean,      0.01 * mean, 0.02 * mean};
    study.approximations.push_back(found);
  };
  add(Displaced::Anterolateral, 0, 1.0, true);
  add(Displaced::Anterolateral, 1, 8.0, true);
  add(Displaced::Anterolateral, 0, 4.0, false);
  add(Displaced::Both, 1, 6.0, false);
  return study;
}

TEST(Summarise, HasMeansByClassAndAnchorAndLeavesOutEmptyOnes) {
  const std::vector<AnchorSummary> all = summarise(by_hand());
  ASSERT_EQ(all.size(), 3u);
  const AnchorSummary& first = all[0];
  EXPECT_EQ(first.protocol, Protocol::Closed);
  EXPECT_EQ(first.displaced, Displaced::Anterolateral);
  EXPECT_EQ(first.anchor.name, "a");
  EXPECT_EQ(first.configurations, 2);
  EXPECT_EQ(first.repaired, 1);
  EXPECT_DOUBLE_EQ(first.mean_mm2, 2.5);
  EXPECT_DOUBLE_EQ(first.sd_of_means_mm2, 1.5);  // of 1 and 4
  EXPECT_DOUBLE_EQ(first.sd_mm2, 1.25);
  EXPECT_DOUBLE_EQ(first.length_sd_mm2, 0.625);
  EXPECT_DOUBLE_EQ(first.angle_sd_mm2, 0.3125);
  EXPECT_DOUBLE_EQ(first.length_slope_mm2_per_mm, 1.875);
  EXPECT_DOUBLE_EQ(first.swing_slope_mm2_per_mm, -2.5);
  EXPECT_DOUBLE_EQ(first.leaking_share, 0.025);
  EXPECT_DOUBLE_EQ(first.clamped_share, 0.05);
  EXPECT_EQ(all[1].anchor.name, "b");
  EXPECT_EQ(all[1].sd_of_means_mm2, 0.0);
  EXPECT_EQ(all[2].displaced, Displaced::Both);
  EXPECT_EQ(all[2].repaired, 0);
}

TEST(Summarise, MovementAndSutureAreOfWhatIsRepaired) {
  const std::vector<AnchorSummary> all = summarise(by_hand());
  ASSERT_EQ(all.size(), 3u);
  EXPECT_DOUBLE_EQ(all[0].movement_mm, 2.0) << "not of the other one, 8 mm";
  EXPECT_DOUBLE_EQ(all[0].suture_mm, 3.0);
  EXPECT_DOUBLE_EQ(all[1].movement_mm, 16.0);
  EXPECT_TRUE(std::isnan(all[2].movement_mm)) << "nothing is repaired";
  EXPECT_TRUE(std::isnan(all[2].suture_mm));
  EXPECT_DOUBLE_EQ(all[2].mean_mm2, 6.0);
}

TEST(FindSummary, NeedsProtocolClassAndAnchor) {
  const std::vector<AnchorSummary> all = summarise(by_hand());
  EXPECT_EQ(find_summary(all, Protocol::Closed, Displaced::Anterolateral, "b"), &all[1]);
  EXPECT_EQ(find_summary(all, Protocol::Closed, Displaced::Both, "b"), &all[2]);
  EXPECT_EQ(find_summary(all, Protocol::Closed, Displaced::Both, "a"), nullptr);
  EXPECT_EQ(find_summary(all, Protocol::Optimum, Displaced::Both, "b"), nullptr);
  EXPECT_EQ(find_summary(all, Protocol::Closed, Displaced::Posteromedial, "b"), nullptr);
  EXPECT_EQ(find_summary({}, Protocol::Closed, Displaced::Both, "b"), nullptr);
}

TEST(PairAnchors, ComparesTheSameDisplacementOfTheSameClass) {
  ApproximationStudy study;
  study.anchors = {{"annulus", 0.0, {}}, {"saddle peak", 0.2, {}}, {"trigone", 0.1, {}}};
  const auto add = [&](Displaced displaced, double apical_mm, std::size_t anchor, double mean,
                       double sd) {
    Approximation found;
    found.displaced = displaced;
    found.displaced_mm = Vec3(0.0, 0.0, apical_mm);
    found.anchor = anchor;
    found.region.mean_mm2 = mean;
    found.region.sd_mm2 = sd;
    study.approximations.push_back(found);
  };
  const auto both_anchors = [&](Displaced displaced, double apical_mm, Vec3 trigone, Vec3 peak) {
    add(displaced, apical_mm, 0, 0.0, 0.0);
    add(displaced, apical_mm, 1, peak.x(), peak.y());
    add(displaced, apical_mm, 2, trigone.x(), trigone.y());
  };
  // Mean, sd. In the mean over displacements the trigone has more.
  both_anchors(Displaced::Both, 1.0, {1.0, 1.0, 0.0}, {2.0, 2.0, 0.0});
  both_anchors(Displaced::Both, 2.0, {3.0, 5.0, 0.0}, {4.0, 4.0, 0.0});
  both_anchors(Displaced::Both, 3.0, {9.0, 2.0, 0.0}, {5.0, 2.0, 0.0});
  add(Displaced::Both, 4.0, 2, 1.0, 1.0);  // without its pair
  both_anchors(Displaced::Posteromedial, 1.0, {7.0, 1.0, 0.0}, {6.0, 2.0, 0.0});
  const PairedAnchors both = pair_anchors(study, Displaced::Both);
  EXPECT_EQ(both.configurations, 3);
  EXPECT_EQ(both.smaller_mean, 2);
  EXPECT_EQ(both.smaller_sd, 1) << "equal is not smaller";
  const PairedAnchors posteromedial = pair_anchors(study, Displaced::Posteromedial);
  EXPECT_EQ(posteromedial.configurations, 1);
  EXPECT_EQ(posteromedial.smaller_mean, 0);
  EXPECT_EQ(posteromedial.smaller_sd, 1);
  EXPECT_EQ(pair_anchors(study, Displaced::Anterolateral).configurations, 0);
}

}  // namespace
}  // namespace coapt
