#include "core/repair/rings.h"

#include <gtest/gtest.h>

namespace coapt {
namespace {

static_assert(kRingShapes.size() == 3);

TEST(Rings, AreFoundByTheirNames) {
  for (const RingShape& shape : kRingShapes) EXPECT_EQ(find_ring(shape.name), &shape);
  EXPECT_EQ(find_ring("own"), nullptr);
  EXPECT_EQ(find_ring(""), nullptr);
}

TEST(Rings, TheCatalogueHoldsTheGenericShapes) {
  EXPECT_EQ(find_ring("generic-classic")->ap_over_transverse, 0.75);
  EXPECT_EQ(find_ring("generic-etlogix-like")->ap_over_transverse, 0.68);
  EXPECT_EQ(find_ring("generic-geoform-like")->ap_over_transverse, 0.51);
  EXPECT_EQ(find_ring("generic-geoform-like")->transverse_factor, 1.12);
}

TEST(Rings, SharesAreThoseOfARing) {
  for (const RingShape& shape : kRingShapes) {
    EXPECT_GE(shape.ap_over_transverse, 0.3);
    EXPECT_LE(shape.ap_over_transverse, 1.0);
    EXPECT_GE(shape.transverse_factor, 0.5);
    EXPECT_LE(shape.transverse_factor, 1.5);
    EXPECT_GE(shape.saddle_over_transverse, 0.0);
    EXPECT_LE(shape.saddle_over_transverse, 0.5);
    EXPECT_FALSE(shape.note.empty());
  }
}

TEST(Rings, ContourHasTheRingsDimensions) {
  const RingShape ring{"", 0.5, 1.1, 0.1, ""};
  const Points contour = ring_contour_mm(ring, 30.0);
  const auto extent = [&contour](int k) {
    return contour.col(k).maxCoeff() - contour.col(k).minCoeff();
  };
  EXPECT_NEAR(extent(0), 33.0, 1e-9);
  EXPECT_NEAR(extent(1), 16.5, 1e-9);
  EXPECT_NEAR(extent(2), 3.3, 0.01);
}

}  // namespace
}  // namespace coapt
