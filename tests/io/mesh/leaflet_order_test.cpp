#include "io/mesh/leaflet_order.h"

#include <gtest/gtest.h>

#include "cone_scene.h"
#include "io/mesh/source_units.h"

namespace coapt {
namespace {

/// An anterior sheet over `share` of the annulus about its front, the posterior one behind it; half as tall.
ImportSource sheets(double share) {
  ImportSource source = cone_source();
  const int half = static_cast<int>(std::lround(180.0 * share));
  TriangleMesh posterior = cone(91 + half, 449 - half);
  posterior.vertices_mm.col(2) *= 0.6;
  source.leaflets = {cone(90 - half, 90 + half), posterior};
  return source;
}

ImportSource swapped(ImportSource source) {
  std::swap(source.leaflets[0], source.leaflets[1]);
  return source;
}

TEST(LeafletOrder, TheShareOfTheAnnulusIsThatOfTheNearestSheet) {
  const ImportSource source = sheets(0.36);
  const LeafletSigns signs = leaflet_signs(source.leaflets, source.annulus_mm);
  EXPECT_NEAR(signs.share[0], 0.36, 0.01);
  EXPECT_NEAR(signs.share[1], 0.64, 0.01);
  EXPECT_GT(signs.height_mm[0], signs.height_mm[1]);
  EXPECT_GT(signs.first_is_anterior, 0.99);
  const ImportSource other = swapped(source);
  EXPECT_NEAR(leaflet_signs(other.leaflets, other.annulus_mm).first_is_anterior,
              1.0 - signs.first_is_anterior, 1e-9);
}

TEST(LeafletOrder, WhatNobodySaysAnatomyDecides) {
  for (const double share : {0.28, 0.36, 0.44}) {
    ImportSource right = sheets(share), wrong = swapped(sheets(share));
    right.order.claim = wrong.order.claim = LeafletClaim::Guessed;
    wrong.order.numbered[0] = "as coapt and most tools number them";
    const Expected<SettledOrder> kept = settle_leaflet_order(right, false),
                                 turned = settle_leaflet_order(wrong, false);
    ASSERT_TRUE(kept && turned);
    EXPECT_FALSE(kept->swapped);
    EXPECT_FALSE(kept->decisions.at(0).look) << kept->decisions[0].reason;
    EXPECT_TRUE(turned->swapped);
    EXPECT_TRUE(turned->decisions.at(0).look) << "the numbers said otherwise";
    EXPECT_EQ(turned->decisions[0].value,
              "the second mesh is the anterior leaflet, the first mesh the posterior one");
    EXPECT_GT(turned->decisions[0].confidence, 0.9);
    EXPECT_EQ(wrong.leaflets[0].vertices_mm, right.leaflets[0].vertices_mm);
  }
}

TEST(LeafletOrder, OrdersThatMeanNothingAreTurnedWithoutALook) {
  ImportSource source = swapped(sheets(0.36));
  source.order.claim = LeafletClaim::Guessed;
  const Expected<SettledOrder> settled = settle_leaflet_order(source, false);
  ASSERT_TRUE(settled && settled->swapped);
  EXPECT_FALSE(settled->decisions.at(0).look);
}

TEST(LeafletOrder, HalfTheAnnulusEachIsLookedAt) {
  ImportSource source = sheets(0.5);
  source.leaflets = {cone(0, 180), cone(180, 359)};
  source.order.claim = LeafletClaim::Guessed;
  const Expected<SettledOrder> settled = settle_leaflet_order(source, false);
  ASSERT_TRUE(settled);
  EXPECT_TRUE(settled->decisions.at(0).look);
}

TEST(LeafletOrder, APlainlyWrongClaimIsRefusedWithBothReadings) {
  for (const LeafletClaim claim : {LeafletClaim::Given, LeafletClaim::Named}) {
    ImportSource source = swapped(sheets(0.36));
    source.order = {
        claim, {"label 1", "label 2"}, {}, "say --label anterior=2 --label posterior=1"};
    const Expected<SettledOrder> refused = settle_leaflet_order(source, false);
    ASSERT_FALSE(refused);
    const std::string& message = refused.errors()[0].message;
    EXPECT_EQ(refused.errors()[0].path, "/leaflets/0");
    for (const char* part : {"label 1 has 64 % of the annulus", "label 2 has 36 % of the annulus",
                             "--label anterior=2", "--trust-labels"})
      EXPECT_NE(message.find(part), std::string::npos) << part << " in " << message;
    const Expected<SettledOrder> trusted = settle_leaflet_order(source, true);
    ASSERT_TRUE(trusted);
    EXPECT_FALSE(trusted->swapped);
    EXPECT_TRUE(trusted->decisions.at(0).look);
    EXPECT_LT(trusted->decisions[0].confidence, 0.1);
  }
}

TEST(LeafletOrder, AClaimThatIsHardlyWrongIsLookedAt) {
  ImportSource source = swapped(sheets(0.43));  // 57 % to the one that is said to be anterior
  const Expected<SettledOrder> settled = settle_leaflet_order(source, false);
  ASSERT_TRUE(settled);
  EXPECT_FALSE(settled->swapped);
  EXPECT_TRUE(settled->decisions.at(0).look);
}

TEST(LeafletOrder, TheUnitOfLengthAndTheAxesDoNotMatter) {
  ImportSource source = sheets(0.4);
  const double sure = leaflet_signs(source.leaflets, source.annulus_mm).first_is_anterior;
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(1.0, Vec3(1.0, 2.0, 3.0).normalized()).toRotationMatrix();
  for (TriangleMesh& mesh : source.leaflets) mesh.vertices_mm = mesh.vertices_mm * turn;
  source.annulus_mm = source.annulus_mm * turn;
  EXPECT_NEAR(leaflet_signs(source.leaflets, source.annulus_mm).first_is_anterior, sure, 0.01);
}

}  // namespace
}  // namespace coapt
