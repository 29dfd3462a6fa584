#include "core/repair/ring_terms.h"

#include <gtest/gtest.h>

#include "core/repair/annuloplasty.h"
#include "core/repair/apply_plan.h"
#include "core/repair/ring_design.h"
#include "core/repair/rings.h"
#include "tests/scenes/small_valve.h"

namespace coapt {
namespace {

// Points of the contour at t = 0, pi/2, pi, 3 pi/2 and -pi/4.
constexpr Index kPosteromedial = 0, kFront = 180, kAnterolateral = 360, kBack = 540, kP3 = 630;

Vec3 at(const Points& contour, Index i) { return contour.row(i); }

Errors problems_of_terms(const RingTerms& terms) {
  ProblemList problems;
  check_ring_terms(terms, "/ring", problems);
  return std::move(problems).take();
}

TEST(RingTerms, WithoutFurtherTermsItIsTheGenericFlatRing) {
  for (const RingShape& shape : kRingShapes) {
    const Points generic = ring_contour_mm(shape, 30.0);
    const Points same = ring_contour_mm(RingTerms{.ap_over_transverse = shape.ap_over_transverse},
                                        ring_width_mm(shape, 30.0));
    EXPECT_LT((generic - same).cwiseAbs().maxCoeff(), 1e-12) << shape.name;
  }
}

// A ring of 30 mm: each term moves what it names by its share of 30 mm and leaves width, depth and saddle as they are.
TEST(RingTerms, WidthDepthAndSaddleAreExactWhateverTheOtherTermsAre) {
  const Points contour = ring_contour_mm({0.7, 0.02, 0.04, 0.15, 0.0, -0.06}, 30.0);
  EXPECT_NEAR(at(contour, kPosteromedial).x() - at(contour, kAnterolateral).x(), 30.0, 1e-9);
  EXPECT_NEAR(at(contour, kFront).y() - at(contour, kBack).y(), 21.0, 1e-9);
  EXPECT_NEAR(at(contour, kFront).x(), 0.0, 1e-9);
  EXPECT_NEAR(at(contour, kBack).x(), 0.0, 1e-9);
  EXPECT_NEAR(at(contour, kFront).z() - at(contour, kPosteromedial).z(), 4.5, 1e-9);
  EXPECT_NEAR(at(contour, kFront).z() - at(contour, kAnterolateral).z(), 4.5, 1e-9);
  EXPECT_NEAR(at(contour, kFront).z() - at(contour, kBack).z(), 0.0, 1e-9);
}

TEST(RingTerms, EachMovesWhatItNames) {
  const Points plain = ring_contour_mm(RingTerms{}, 30.0);
  const auto moved = [&](const RingTerms& terms, Index i) {
    const Points contour = ring_contour_mm(terms, 30.0);
    // Against the front's middle, because each contour lies about a centroid of its own.
    return Vec3((at(contour, i) - at(contour, kFront)) - (at(plain, i) - at(plain, kFront)));
  };
  // The ends come forward by twice what either middle goes back, which is the same.
  EXPECT_NEAR(moved({.flattening = 0.03}, kPosteromedial).y(), 1.8, 1e-9);
  EXPECT_NEAR(moved({.flattening = 0.03}, kBack).y(), 0.0, 1e-9);
  EXPECT_NEAR(moved({.p3_inset = 0.05}, kP3).y(), 1.5, 1e-9);
  EXPECT_NEAR(moved({.p3_inset = 0.05}, kP3).z(), 0.0, 1e-9);
  EXPECT_NEAR(moved({.elevation = 0.1}, kBack).z(), 3.0, 1e-9);
  EXPECT_NEAR(moved({.elevation = 0.1}, kPosteromedial).z(), 0.0, 1e-9);
  EXPECT_NEAR(moved({.p3_elevation = -0.1}, kP3).z(), -3.0, 1e-9);
  EXPECT_NEAR(moved({.p3_elevation = -0.1}, kBack).z(), 0.0, 1e-9);
}

TEST(RingTerms, ADentIsAsDeepAsItIsBelowTheHull) {
  Points notched(5, 3);  // a square of 10 mm, its upper side notched by 2 mm
  notched << 0, 0, 0, 10, 0, 1, 10, 10, 2, 5, 8, 3, 0, 10, 4;
  EXPECT_NEAR(deepest_dent_mm(notched), 2.0, 1e-12);
  EXPECT_NEAR(deepest_dent_mm(ring_contour_mm(RingTerms{}, 30.0)), 0.0, 1e-9);
}

TEST(RingTerms, WhatCannotBeSewnIsRefused) {
  EXPECT_TRUE(problems_of_terms({}).empty());
  EXPECT_EQ(unsewable({}), 0.0);
  const RingTerms bean{.ap_over_transverse = 0.45, .flattening = 0.06, .p3_inset = 0.12};
  EXPECT_GT(unsewable(bean), 0.0);
  ASSERT_EQ(problems_of_terms(bean).size(), 1u);
  EXPECT_EQ(problems_of_terms(bean)[0].code, ErrorCode::BadGeometry);
  EXPECT_EQ(problems_of_terms(bean)[0].path, "/ring");
  EXPECT_EQ(unsewable({.ap_over_transverse = 0.1, .p3_inset = 0.12}), 1.0) << "crosses itself";
  for (const RingTermRow& row : kRingTerms) {
    RingTerms terms;
    terms.*row.member = row.range.max + 0.01;
    ASSERT_EQ(problems_of_terms(terms).size(), 1u);
    EXPECT_EQ(problems_of_terms(terms)[0].path, std::string("/ring/") + row.name);
  }
}

// The small valve's annulus is an ellipse of 36 x 28 mm in z = 0, its saddle peak at (0, 14, 0).
TEST(DesignedRing, KeepsTheSaddlePeakAndDrawsMidPosteriorIn) {
  const DesignedRing ring{{"mine", {.ap_over_transverse = 0.6, .p3_inset = 0.05}}, 30.0};
  const Valve ringed = *apply_plan(small_valve(), {{Annuloplasty{ring}}});
  EXPECT_NEAR((Vec3(ringed.annulus_mm.row(2)) - Vec3(0.0, 14.0, 0.0)).norm(), 0.0, 1e-9);
  EXPECT_NEAR((Vec3(ringed.annulus_mm.row(6)) - Vec3(0.0, 14.0 - 18.0, 0.0)).norm(), 0.0, 1e-9);
  EXPECT_GT(ringed.annulus_mm(7, 1), ringed.annulus_mm(5, 1)) << "P3 lies forward of P1";
}

TEST(DesignedRing, IsSizedByItsRule) {
  EXPECT_EQ(ring_size_mm(0.9, 36.0), 32.0);  // 32.4
  EXPECT_EQ(ring_size_mm(0.5, 30.0), 24.0) << "the smallest on sale";
  EXPECT_EQ(ring_size_mm(1.0, 60.0), 40.0) << "the largest on sale";
  const Annuloplasty step = sized_ring({{"mine", {}}, 0.8}, small_valve());
  EXPECT_EQ(std::get<DesignedRing>(step.ring).size_mm, 28.0);  // 28.8
  EXPECT_EQ(shape_of(step), "mine");
}

TEST(DesignedRing, NamesOfOtherShapesAreRefused) {
  for (const char* name : {"", "own", "designed", "generic-classic"}) {
    const RingDesign design{{name, {}}, 0.9};
    ASSERT_EQ(check_ring_design(design).size(), 1u) << name;
    EXPECT_EQ(check_ring_design(design)[0].path, "/ring/name");
  }
  EXPECT_EQ(check_ring_design({{"mine", {}}, 1.2})[0].path, "/sizing/width_over_transverse");
  const Expected<Valve> refused =
      apply_plan(small_valve(), {{Annuloplasty{DesignedRing{{"own", {}}, 31.0}}}});
  ASSERT_EQ(refused.errors().size(), 2u);
  EXPECT_EQ(refused.errors()[0].path, "/steps/0/ring/name");
  EXPECT_EQ(refused.errors()[1].path, "/steps/0/size_mm");
}

}  // namespace
}  // namespace coapt
