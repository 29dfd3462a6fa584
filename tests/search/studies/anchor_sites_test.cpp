#include "search/studies/anchor_sites.h"

#include <gtest/gtest.h>

#include "core/repair/plan.h"
#include "tests/scenes/small_preset.h"
#include "tests/scenes/small_valve.h"

namespace coapt {
namespace {

TEST(AnchorSites, OfTheSmallValveAreWhereItsVerticesAre) {
  const Valve valve = small_valve();
  const std::vector<AnchorSite> sites = thesis_anchors(valve);
  ASSERT_EQ(sites.size(), 2u);
  EXPECT_EQ(sites[0].name, "trigone");
  EXPECT_EQ(sites[1].name, "saddle peak");
  EXPECT_EQ(sites[1].around, 0.25);
  // Outwards for the posteromedial muscle is +x, posterior -y, apical -z; saddle peak (0, 14, 0).
  const Vec3 tip = papillary_tip_mm(valve, Side::Posteromedial);
  EXPECT_NEAR((sites[1].at_mm[1] - Vec3(-tip.x(), tip.y() - 14.0, tip.z())).norm(), 0.0, 1e-12);
  const Vec3 trigone = annulus_position_mm(valve, valve.landmarks.posteromedial_trigone) - tip;
  EXPECT_NEAR((sites[0].at_mm[1] - Vec3(trigone.x(), -trigone.y(), -trigone.z())).norm(), 0.0,
              1e-12);
}

TEST(AnchorSites, OfAMirrorSymmetricValveAreTheSameForBothMuscles) {
  const Valve& valve = small_preset("porcine-1");
  for (const AnchorSite& site : thesis_anchors(valve)) {
    EXPECT_NEAR((site.at_mm[0] - site.at_mm[1]).norm(), 0.0, 1e-6) << site.name;
    EXPECT_NEAR((site.at_mm[0] - site.at_mm[2]).norm(), 0.0, 1e-6) << site.name;
    EXPECT_LT(site.at_mm[0].z(), -15.0) << "high above the tips";
  }
  const std::vector<AnchorSite> scan = annulus_scan(valve, 24);
  for (const AnchorSite& site : scan)
    EXPECT_NEAR((site.at_mm[0] - site.at_mm[1]).norm(), 0.0, 1e-6) << site.around;
}

TEST(AnchorSites, BothMusclesTakeTheMeanOfTheTwo) {
  Valve valve = small_valve();
  for (PapillaryHead& head : valve.heads)
    if (head.side == Side::Posteromedial) head.tip_mm += Vec3(2.0, -4.0, -6.0);
  for (const AnchorSite& site : thesis_anchors(valve)) {
    EXPECT_NEAR((site.at_mm[2] - 0.5 * (site.at_mm[0] + site.at_mm[1])).norm(), 0.0, 1e-12);
    // The posteromedial tip is further out, back and down: its anchor seems nearer in and higher.
    EXPECT_NEAR((site.at_mm[0] - site.at_mm[1] - Vec3(2.0, 4.0, 6.0)).norm(), 0.0, 1e-12);
  }
}

TEST(AnchorSites, ATipDisplacedTowardsItsSiteGoesTowardsItsAnchor) {
  const Valve& valve = small_preset("porcine-thesis-tables");
  const std::vector<AnchorSite> sites = thesis_anchors(valve);
  for (std::size_t s = 0; s < sites.size(); ++s)
    for (const Side side : {Side::Anterolateral, Side::Posteromedial}) {
      const auto k = static_cast<std::size_t>(side == Side::Posteromedial);
      const Expected<Valve> half =
          configure(valve, displacement(kDisplaced[k], 0.5 * sites[s].at_mm[k]));
      ASSERT_TRUE(half) << half.errors().front().message;
      const Vec3 anchor = anchor_mm(
          valve,
          {.side = side, .anchor = s == 0 ? Anchor::IpsilateralTrigone : Anchor::SaddlePeak});
      const Vec3 middle = 0.5 * (papillary_tip_mm(valve, side) + anchor);
      EXPECT_NEAR((papillary_tip_mm(*half, side) - middle).norm(), 0.0, 1e-9) << sites[s].name;
    }
}

TEST(AnnulusScan, GoesEvenlyAroundAndMeetsSaddlePeakAndTrigone) {
  const Valve& valve = small_preset("human-normal");
  const std::vector<AnchorSite> scan = annulus_scan(valve, 8), thesis = thesis_anchors(valve);
  ASSERT_EQ(scan.size(), 8u);
  for (std::size_t i = 0; i < 8; ++i)
    EXPECT_DOUBLE_EQ(scan[i].around, 0.125 * static_cast<double>(i));
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_NEAR((scan[2].at_mm[k] - thesis[1].at_mm[k]).norm(), 0.0, 1e-9);
  }
  // The trigone's own place on the annulus leads back to it.
  const Vec3 there = annulus_point_mm(valve, thesis[0].around);
  EXPECT_NEAR((there - annulus_position_mm(valve, valve.landmarks.posteromedial_trigone)).norm(),
              0.0, 1e-9);
  EXPECT_TRUE(annulus_scan(valve, 0).empty());
}

}  // namespace
}  // namespace coapt
