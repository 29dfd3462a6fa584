#include "search/studies/configuration.h"

#include <gtest/gtest.h>

#include "core/repair/apply_plan.h"
#include "tests/scenes/small_valve.h"

namespace coapt {
namespace {

TEST(Displacement, GoesToTheMusclesOfItsClass) {
  const Vec3 by(1.0, 2.0, 3.0);
  const Configuration lateral = displacement(Displaced::Anterolateral, by, 2);
  EXPECT_EQ(lateral.change.anterolateral_mm, by);
  EXPECT_EQ(lateral.change.posteromedial_mm, Vec3::Zero());
  EXPECT_EQ(lateral.ring_sizes_below, 2);
  const Configuration medial = displacement(Displaced::Posteromedial, by);
  EXPECT_EQ(medial.change.anterolateral_mm, Vec3::Zero());
  EXPECT_EQ(medial.change.posteromedial_mm, by);
  EXPECT_EQ(medial.ring_sizes_below, 0);
}

TEST(Configure, BothMusclesMoveAsMirrorImages) {
  // The small valve is symmetric about x = 0.
  const Expected<Valve> moved =
      configure(small_valve(), displacement(Displaced::Both, Vec3(1.0, 2.0, 3.0)));
  ASSERT_TRUE(moved);
  const Vec3 lateral = papillary_tip_mm(*moved, Side::Anterolateral);
  const Vec3 medial = papillary_tip_mm(*moved, Side::Posteromedial);
  EXPECT_NEAR((Vec3(-lateral.x(), lateral.y(), lateral.z()) - medial).norm(), 0.0, 1e-12);
  const Vec3 way = medial - papillary_tip_mm(small_valve(), Side::Posteromedial);
  EXPECT_NEAR((way - Vec3(1.0, -2.0, -3.0)).norm(), 0.0, 1e-12);
}

TEST(Configure, IsARingAndThenRemodelling) {
  const Configuration wanted = displacement(Displaced::Anterolateral, Vec3(2.0, 0.0, 4.0), 3);
  const Expected<Valve> ringed = apply_plan(small_valve(), {{Annuloplasty{OwnRing{3}}}});
  ASSERT_TRUE(ringed);
  const Expected<Valve> by_hand = remodel(*ringed, wanted.change);
  const Expected<Valve> configured = configure(small_valve(), wanted);
  ASSERT_TRUE(by_hand && configured);
  EXPECT_EQ(configured->annulus_mm, by_hand->annulus_mm);
  for (std::size_t h = 0; h < configured->heads.size(); ++h)
    EXPECT_EQ(configured->heads[h].tip_mm, by_hand->heads[h].tip_mm);
  // Three sizes of 2 mm off a transverse diameter of 36 mm.
  const Landmarks& marks = configured->landmarks;
  EXPECT_NEAR((annulus_position_mm(*configured, marks.posteromedial_commissure) -
               annulus_position_mm(*configured, marks.anterolateral_commissure))
                  .norm(),
              30.0, 0.1);
}

TEST(Configure, WithoutAnyChangeLeavesTheValveAsItIs) {
  const Expected<Valve> same = configure(small_valve(), {});
  ASSERT_TRUE(same);
  EXPECT_NEAR((same->annulus_mm - small_valve().annulus_mm).norm(), 0.0, 1e-12);
}

TEST(Configure, WhatIsImpossibleIsSaidWithItsPlace) {
  const Expected<Valve> far =
      configure(small_valve(), displacement(Displaced::Posteromedial, Vec3(0.0, 40.0, 0.0)));
  ASSERT_FALSE(far);
  EXPECT_EQ(far.errors().front().path, "/posteromedial_mm/1");
  EXPECT_EQ(far.errors().front().code, ErrorCode::OutOfRange);
  EXPECT_FALSE(configure(small_valve(), displacement(Displaced::Both, Vec3::Zero(), 7)))
      << "seven sizes below";
}

}  // namespace
}  // namespace coapt
