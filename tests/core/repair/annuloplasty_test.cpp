#include "core/repair/annuloplasty.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/repair/apply_plan.h"
#include "core/repair/rings.h"
#include "core/valve/annulus_frame.h"
#include "tests/core/repair/moved_valve.h"
#include "tests/scenes/small_valve.h"

namespace coapt {
namespace {

constexpr RingShape kSaddle{"saddle", 0.75, 1.0, 0.2, ""};

Valve with_ring(const Annuloplasty& ring) { return *apply_plan(small_valve(), {{ring}}); }

std::string refusal(const Annuloplasty& ring) {
  const Expected<Valve> refused = apply_plan(small_valve(), {{ring}});
  if (refused) return "accepted";
  EXPECT_EQ(refused.errors().size(), 1u);
  return refused.errors()[0].path;
}

// The small valve's annulus is an ellipse of 36 x 28 mm in z = 0, its saddle peak at (0, 14, 0).

TEST(Annuloplasty, OneSizeBelowTakesTwoMillimetresOfTheTransverseDimension) {
  const Valve ringed = with_ring({OwnRing{1}});
  EXPECT_NEAR(transverse_diameter_mm(ringed), 34.0, 1e-12);
  EXPECT_NEAR(ap_diameter_mm(ringed), 28.0 * 34.0 / 36.0, 1e-12);
}

TEST(Annuloplasty, OwnShapeShrinksInProportionTowardsTheSaddlePeak) {
  const Valve before = small_valve();
  const Valve ringed = with_ring({OwnRing{3}});
  const double factor = 30.0 / 36.0;
  for (int i = 0; i < 8; ++i) {
    const Vec3 native = before.annulus_mm.row(i);
    const Vec3 expected(factor * native.x(), 14.0 - factor * (14.0 - native.y()), 0.0);
    EXPECT_NEAR((Vec3(ringed.annulus_mm.row(i)) - expected).norm(), 0.0, 1e-12);
  }
  EXPECT_EQ(ringed.heads[0].tip_mm, before.heads[0].tip_mm);
  EXPECT_EQ(ringed.rest_mm, before.rest_mm);
}

TEST(Annuloplasty, OwnShapeAndSizeChangesNothing) {
  const Valve ringed = with_ring({OwnRing{0}});
  EXPECT_NEAR((ringed.annulus_mm - small_valve().annulus_mm).norm(), 0.0, 1e-12);
}

TEST(Annuloplasty, CatalogueRingKeepsTheSaddlePeakAndDrawsMidPosteriorIn) {
  const Valve ringed = with_ring({CatalogueRing{"generic-classic", 30.0}});
  EXPECT_NEAR((Vec3(ringed.annulus_mm.row(2)) - Vec3(0.0, 14.0, 0.0)).norm(), 0.0, 1e-9);
  EXPECT_NEAR((Vec3(ringed.annulus_mm.row(6)) - Vec3(0.0, 14.0 - 22.5, 0.0)).norm(), 0.0, 1e-9);
}

TEST(Annuloplasty, VerticesLieOnTheRingInTheirOrderAndSymmetrically) {
  const Valve ringed = with_ring({CatalogueRing{"generic-geoform-like", 28.0}});
  const Points contour = ring_contour_mm(*find_ring("generic-geoform-like"), 28.0);
  const double front = 14.0 - contour.col(1).maxCoeff();
  double turned = 0.0;
  for (int i = 0; i < 8; ++i) {
    const Vec3 on_ring = Vec3(ringed.annulus_mm.row(i)) - Vec3(0.0, front, 0.0);
    EXPECT_LT((contour.rowwise() - on_ring.transpose()).rowwise().norm().minCoeff(), 0.1);
    const Vec3 next = Vec3(ringed.annulus_mm.row((i + 1) % 8)) - Vec3(0.0, front, 0.0);
    const double step = std::atan2(on_ring.cross(next).z(), on_ring.dot(next));
    EXPECT_GT(step, 0.0);
    turned += step;
    const int twin = (12 - i) % 8;  // the mirror image of column i
    EXPECT_NEAR(ringed.annulus_mm(i, 0), -ringed.annulus_mm(twin, 0), 1e-9);
    EXPECT_NEAR(ringed.annulus_mm(i, 1), ringed.annulus_mm(twin, 1), 1e-9);
  }
  EXPECT_NEAR(turned, 2.0 * std::acos(-1.0), 1e-9);
}

TEST(Annuloplasty, SaddleRingIsHighInFrontAndBehind) {
  Valve ringed = small_valve();
  suture_ring(kSaddle, 30.0, ringed);
  const double peak = ring_contour_mm(kSaddle, 30.0).col(2).maxCoeff();
  EXPECT_GT(peak, 2.5);  // about half of 0.2 x 30
  EXPECT_NEAR(ringed.annulus_mm(2, 2), peak, 1e-6);
  EXPECT_NEAR(ringed.annulus_mm(6, 2), peak, 1e-6);
  EXPECT_LT(ringed.annulus_mm(0, 2), -1.0);
}

TEST(Annuloplasty, CommutesWithRigidMotions) {
  const Motion motion{Eigen::AngleAxisd(0.4, Vec3(1.0, -2.0, 3.0).normalized()).toRotationMatrix(),
                      Vec3(1.0, 2.0, -3.0)};
  for (const Annuloplasty& ring :
       {Annuloplasty{OwnRing{2}}, Annuloplasty{CatalogueRing{"generic-geoform-like", 32.0}}}) {
    const Valve then_moved = moved(*apply_plan(small_valve(), {{ring}}), motion);
    const Valve moved_first = *apply_plan(moved(small_valve(), motion), {{ring}});
    EXPECT_NEAR((then_moved.annulus_mm - moved_first.annulus_mm).norm(), 0.0, 1e-9);
  }
  Valve ringed = small_valve(), moved_first = moved(small_valve(), motion);
  suture_ring(kSaddle, 32.0, ringed);
  suture_ring(kSaddle, 32.0, moved_first);
  EXPECT_NEAR((moved(ringed, motion).annulus_mm - moved_first.annulus_mm).norm(), 0.0, 1e-9);
}

TEST(Annuloplasty, LeavesAtLeastHalfOfTheTransverseDiameter) {
  // A transverse diameter of 12 mm: three sizes leave 6, four are too many.
  Valve narrow = small_valve();
  narrow.annulus_mm.col(0) /= 3.0;
  const auto ring = [&narrow](int sizes_below) {
    return apply_plan(narrow, {{Annuloplasty{OwnRing{sizes_below}}}});
  };
  ASSERT_TRUE(ring(3));
  EXPECT_NEAR(transverse_diameter_mm(*ring(3)), 6.0, 1e-9);
  for (const int sizes : {4, 6}) {
    const Expected<Valve> refused = ring(sizes);
    ASSERT_FALSE(refused);
    ASSERT_EQ(refused.errors().size(), 1u);
    EXPECT_EQ(refused.errors()[0].code, ErrorCode::ImpossibleStep);
    EXPECT_EQ(refused.errors()[0].path, "/steps/0/sizes_below");
    EXPECT_NE(refused.errors()[0].message.find("from 0 to 3"), std::string::npos);
  }
}

TEST(Annuloplasty, RefusesWhatIsNotMade) {
  EXPECT_EQ(refusal({CatalogueRing{"round", 30.0}}), "/steps/0/shape");
  EXPECT_EQ(refusal({CatalogueRing{"generic-classic", 31.0}}), "/steps/0/size_mm");
  EXPECT_EQ(refusal({CatalogueRing{"generic-classic", 42.0}}), "/steps/0/size_mm");
  EXPECT_EQ(refusal({CatalogueRing{"generic-classic", std::nan("")}}), "/steps/0/size_mm");
  EXPECT_EQ(refusal({OwnRing{7}}), "/steps/0/sizes_below");
  EXPECT_EQ(refusal({OwnRing{-1}}), "/steps/0/sizes_below");
  EXPECT_EQ(refusal({CatalogueRing{"own", 30.0}}), "/steps/0/shape");
}

}  // namespace
}  // namespace coapt
