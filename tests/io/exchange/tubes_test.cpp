#include "io/exchange/tubes.h"

#include <gtest/gtest.h>

namespace coapt {
namespace {

TEST(Tubes, VerticesLieARadiusFromTheAxisAndNormalsLookOutwards) {
  const std::vector<TubeAxis> axes = {{{1.0, 2.0, 3.0}, {1.0, 2.0, 8.0}, 0.5}};
  const Tubes tubes = make_tubes(axes, axes);
  ASSERT_EQ(tubes.vertices_mm.rows(), 12);
  ASSERT_EQ(tubes.faces.rows(), 12);
  for (int i = 0; i < 12; ++i) {
    EXPECT_NEAR((tubes.vertices_mm.row(i).head<2>() - Eigen::RowVector2d(1.0, 2.0)).norm(), 0.5,
                1e-12);
    EXPECT_NEAR(tubes.vertices_mm(i, 2), i < 6 ? 3.0 : 8.0, 1e-12);
  }
  for (const auto& face : tubes.faces.rowwise()) {
    const Vec3 a = tubes.vertices_mm.row(face[0]), b = tubes.vertices_mm.row(face[1]),
               c = tubes.vertices_mm.row(face[2]);
    EXPECT_GT((b - a).cross(c - a).dot(Vec3(tubes.normals.row(face[0]))), 0.0);
  }
}

TEST(Tubes, ATubeThatTurnsDoesNotTwist) {
  const std::vector<TubeAxis> before = {{{0, 0, 0}, {0, 0, 10}, 0.5}};
  const std::vector<TubeAxis> after = {{{0, 0, 0}, {3, 1, 9}, 0.5}};
  const Points moved =
      make_tubes(after, before).vertices_mm - make_tubes(before, before).vertices_mm;
  for (int i = 0; i < 6; ++i) EXPECT_LT(moved.row(i).norm(), 0.5);  // the end that stays
}

TEST(Tubes, APieceWithoutLengthIsFinite) {
  const std::vector<TubeAxis> axes = {{{1, 1, 1}, {1, 1, 1}, 0.5}};
  EXPECT_TRUE(make_tubes(axes, axes).vertices_mm.allFinite());
}

}  // namespace
}  // namespace coapt
