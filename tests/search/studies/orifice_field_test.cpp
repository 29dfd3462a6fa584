#include "search/studies/orifice_field.h"

#include <gtest/gtest.h>

#include "tests/search/studies/study_scene.h"

namespace coapt {
namespace {

/// Linear along each axis: what trilinear interpolation reproduces.
double trilinear(const Vec3& d) {
  return 3.0 + 2.0 * d.x() - d.y() + 4.0 * d.z() + 0.5 * d.x() * d.y() - 0.25 * d.y() * d.z() +
         0.125 * d.x() * d.y() * d.z();
}

TEST(OrificeField, LookupReproducesWhatIsLinearAlongEachAxis) {
  OrificeTable table = small_table(known_at_nodes(-2, 8, trilinear));
  OrificeField clamped(table, Protocol::LookupClamped), extended(table, Protocol::LookupExtended);
  for (const Vec3& place : {Vec3(0.0, 0.0, 0.0), Vec3(6.0, 6.0, 6.0), Vec3(1.0, 2.5, 3.0),
                            Vec3(0.3, 4.7, 5.999), Vec3(5.5, 0.125, 0.0)})
    for (const Displaced displaced : kDisplaced) {
      ASSERT_TRUE(clamped.at(displaced, place).has_value());
      EXPECT_NEAR(*clamped.at(displaced, place), trilinear(place), 1e-12);
      EXPECT_NEAR(*extended.at(displaced, place), trilinear(place), 1e-12);
    }
  EXPECT_NEAR(*extended.at(Displaced::Both, Vec3(-1.5, 7.25, -0.5)),
              trilinear(Vec3(-1.5, 7.25, -0.5)), 1e-12);
  EXPECT_FALSE(clamped.anything_wanted() || extended.anything_wanted());
  EXPECT_EQ(table.closures(), 0);
}

TEST(OrificeField, ClampedTakesTheBordersOrificeOutside) {
  OrificeTable table = small_table(known_at_nodes(0, 6, trilinear));
  OrificeField field(table, Protocol::LookupClamped);
  EXPECT_NEAR(*field.at(Displaced::Both, Vec3(-3.0, 2.5, 9.0)), trilinear(Vec3(0.0, 2.5, 6.0)),
              1e-12);
  EXPECT_TRUE(OrificeField::outside_grid(Vec3(0.0, 0.0, -0.001)));
  EXPECT_TRUE(OrificeField::outside_grid(Vec3(6.001, 3.0, 3.0)));
  EXPECT_FALSE(OrificeField::outside_grid(Vec3(0.0, 6.0, 3.0)));
}

TEST(OrificeField, ExtendedAsksForTheMissingNodesAndClosesEachOnce) {
  OrificeTable table = small_table(known_at_nodes(0, 6, trilinear));
  OrificeField field(table, Protocol::LookupExtended);
  const Vec3 above(2.0, 3.5, -0.25), beside(2.0, 3.5, -0.75);
  EXPECT_FALSE(field.at(Displaced::Posteromedial, above));
  EXPECT_FALSE(field.at(Displaced::Posteromedial, beside));
  EXPECT_EQ(table.closures(), 0) << "asking closes nothing";
  EXPECT_TRUE(field.anything_wanted());
  field.close_wanted();
  EXPECT_FALSE(field.anything_wanted());
  EXPECT_EQ(table.closures(), 2 + 3) << "apical -1 at posterior 3 and 4, and what these start from";
  const auto known = [&](double posterior, double apical) {
    return table.find(displacement(Displaced::Posteromedial, Vec3(2.0, posterior, apical)))
        ->area_mm2;
  };
  ASSERT_TRUE(field.at(Displaced::Posteromedial, above));
  EXPECT_NEAR(*field.at(Displaced::Posteromedial, above),
              0.5 * (0.25 * (known(3, -1) + known(4, -1)) + 0.75 * (known(3, 0) + known(4, 0))),
              1e-9);
  EXPECT_TRUE(field.at(Displaced::Posteromedial, beside));
  field.close_wanted();
  EXPECT_EQ(table.closures(), 5);
}

TEST(OrificeField, ClosedAsksForExactlyThePosition) {
  for (const Protocol protocol : {Protocol::Closed, Protocol::Optimum}) {
    OrificeTable table = small_table(known_at_nodes(0, 6, trilinear));
    OrificeField field(table, protocol);
    EXPECT_EQ(*field.at(Displaced::Both, Vec3(1.0, 2.0, 3.0)), trilinear(Vec3(1.0, 2.0, 3.0)));
    const Vec3 between(0.5, 1.0, 2.0);
    EXPECT_FALSE(field.at(Displaced::Both, between));
    EXPECT_FALSE(field.at(Displaced::Both, between));
    field.close_wanted();
    EXPECT_EQ(table.closures(), 1 + 4) << "with the corners of its simplex";
    ASSERT_NE(table.find(displacement(Displaced::Both, between)), nullptr);
    EXPECT_EQ(*field.at(Displaced::Both, between),
              table.find(displacement(Displaced::Both, between))->area_mm2);
  }
}

TEST(Protocols, HaveDifferentNames) {
  for (const Protocol a : kProtocols)
    for (const Protocol b : kProtocols)
      EXPECT_EQ(a == b, std::string(to_string(a)) == to_string(b));
}

}  // namespace
}  // namespace coapt
