#include "core/valve/vertex_normals.h"

#include <gtest/gtest.h>

namespace coapt {
namespace {

TEST(VertexNormals, AreMeansOfTheFacesAroundByArea) {
  // A corner of a box of 1 x 2 x 4 mm: its faces at the corner have areas of 4, 2 and 1 mm2.
  const Points vertices{{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {0, 0, 4}, {9, 9, 9}};
  const Faces faces{{0, 2, 3}, {0, 3, 1}, {0, 1, 2}};
  const Points normals = vertex_normals(vertices, faces);
  EXPECT_TRUE(normals.row(0).transpose().isApprox(Vec3(4, 2, 1).normalized()));
  EXPECT_TRUE(normals.row(1).transpose().isApprox(Vec3(0, 2, 1).normalized()));
  EXPECT_TRUE(normals.row(4).isZero(0.0)) << "no face";
}

TEST(VertexNormals, FacesThatCancelLeaveNone) {
  const Points vertices{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  EXPECT_TRUE(vertex_normals(vertices, Faces{{0, 1, 2}, {0, 2, 1}}).isZero(0.0));
}

}  // namespace
}  // namespace coapt
