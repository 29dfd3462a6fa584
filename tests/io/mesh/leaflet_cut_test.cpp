#include "io/mesh/leaflet_cut.h"

#include <gtest/gtest.h>

namespace coapt {
namespace {

TEST(LeafletCut, BeginsWhereTheSheetIsNearestToTheAnnulusBetweenItsCorners) {
  // From 4 mm outside the annulus inwards, then 20 mm down; 10 mm wide.
  TriangleMesh sheet;
  sheet.vertices_mm.resize(6, 3);
  sheet.vertices_mm << 25, -5, 0, 25, 5, 0, 10, -5, 0, 10, 5, 0, 10, -5, -20, 10, 5, -20;
  sheet.faces.resize(4, 3);
  sheet.faces << 0, 1, 3, 0, 3, 2, 2, 3, 5, 2, 5, 4;
  const LeafletCut cut = cut_leaflets({sheet}, Vec3(21, 0, 1));
  ASSERT_GE(cut.line_mm.size(), 4U);
  EXPECT_EQ(cut.sheet, 0);
  EXPECT_LT((cut.line_mm[0] - Eigen::Vector2d(21, 1)).norm(), 1e-9);
  EXPECT_LT((cut.line_mm[1] - Eigen::Vector2d(21, 0)).norm(), 1e-9);
  EXPECT_LT((cut.line_mm.back() - Eigen::Vector2d(10, -20)).norm(), 1e-9);
  EXPECT_NEAR(cut.length_mm(), 1.0 + 11.0 + 20.0, 1e-9);
}

}  // namespace
}  // namespace coapt
