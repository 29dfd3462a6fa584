#include "io/mesh/sheet_repair.h"

#include <gtest/gtest.h>

#include "cone_scene.h"

namespace coapt {
namespace {

/// A square of n x n cells of 1 mm at z = 0.
TriangleMesh square(int n) {
  TriangleMesh mesh{Points((n + 1) * (n + 1), 3), Faces(2 * n * n, 3)};
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i) mesh.vertices_mm.row(j * (n + 1) + i) << i, j, 0.0;
  for (int j = 0, f = 0; j < n; ++j)
    for (int i = 0; i < n; ++i, f += 2) {
      const int a = j * (n + 1) + i, b = a + 1, c = a + n + 1, d = c + 1;
      mesh.faces.row(f) << a, b, d;
      mesh.faces.row(f + 1) << a, d, c;
    }
  return mesh;
}

/// Without the cells [from, to) in both directions.
TriangleMesh with_hole(int n, int from, int to) {
  std::vector<bool> kept;
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i)
      kept.insert(kept.end(), 2, i < from || i >= to || j < from || j >= to);
  return part_of(square(n), kept);
}

TriangleMesh joined(const TriangleMesh& a, const TriangleMesh& b) {
  TriangleMesh both{Points(a.vertices_mm.rows() + b.vertices_mm.rows(), 3),
                    Faces(a.faces.rows() + b.faces.rows(), 3)};
  both.vertices_mm << a.vertices_mm, b.vertices_mm;
  both.faces << a.faces, (b.faces.array() + static_cast<int>(a.vertices_mm.rows())).matrix();
  return both;
}

TriangleMesh moved(TriangleMesh mesh, double x_mm) {
  mesh.vertices_mm.col(0).array() += x_mm;
  return mesh;
}

TEST(SheetRepair, ASoundSheetStaysAsItIs) {
  const auto sheet = repaired_sheet(square(10), 1);
  ASSERT_TRUE(sheet);
  EXPECT_EQ(sheet->mesh.faces, square(10).faces);
  EXPECT_EQ(sheet->welded + sheet->collapsed + sheet->turned + sheet->islands, 0);
  EXPECT_TRUE(sheet->holes.empty());
}

TEST(SheetRepair, HolesAreNamedWithTheirWidthAndPlace) {
  // 3 x 3 cells of 10: the corners are 2.12 mm from the middle, the others 1.5 and 1.58.
  const auto sheet = repaired_sheet(with_hole(10, 4, 7), 1);
  ASSERT_TRUE(sheet);
  ASSERT_EQ(sheet->holes.size(), 1u);
  EXPECT_TRUE(sheet->holes[0].filled);
  EXPECT_NEAR(sheet->holes[0].width_mm, 3.52, 0.01);
  EXPECT_LT((sheet->holes[0].centre_mm - Vec3(5.5, 5.5, 0.0)).norm(), 1e-9);
  EXPECT_NEAR(area_mm2(sheet->mesh), 100.0, 1e-9);
  EXPECT_EQ(boundary_loops(sheet->mesh).size(), 1u);
  const auto narrow = repaired_sheet(with_hole(10, 4, 5), 1);
  ASSERT_TRUE(narrow);
  EXPECT_FALSE(narrow->holes[0].filled);
}

TEST(SheetRepair, AHoleOfMoreThanSixMillimetresIsRefused) {
  const auto sheet = repaired_sheet(with_hole(20, 5, 12), 1);
  ASSERT_FALSE(sheet);
  EXPECT_NE(sheet.errors()[0].message.find("has a hole 8"), std::string::npos)
      << sheet.errors()[0].message;
}

TEST(SheetRepair, SmallIslandsAreDroppedAndLargeOnesRefused) {
  const auto sheet = repaired_sheet(joined(square(10), moved(square(2), 30.0)), 1);
  ASSERT_TRUE(sheet);
  EXPECT_EQ(sheet->islands, 1);
  EXPECT_NEAR(sheet->islands_mm2, 4.0, 1e-9);
  EXPECT_NEAR(area_mm2(sheet->mesh), 100.0, 1e-9);
  const auto two = repaired_sheet(joined(square(10), moved(square(5), 30.0)), 1);
  ASSERT_FALSE(two);
  EXPECT_NE(two.errors()[0].message.find("comes in 2 parts of 100, 25 mm2"), std::string::npos)
      << two.errors()[0].message;
}

TEST(SheetRepair, TurnedFacesAreTurnedBackAndCornersWelded) {
  TriangleMesh mesh = joined(square(10), moved(square(10), 10.0));  // share an edge of the square
  mesh.faces.row(5).reverseInPlace();
  mesh.faces.conservativeResize(mesh.faces.rows() + 1, 3);
  mesh.faces.row(mesh.faces.rows() - 1) << 3, 3, 4;
  const auto sheet = repaired_sheet(mesh, 1);
  ASSERT_TRUE(sheet);
  EXPECT_EQ(sheet->welded, 11);
  EXPECT_EQ(sheet->turned, 1);
  EXPECT_EQ(sheet->collapsed, 1);
  EXPECT_EQ(boundary_loops(sheet->mesh).size(), 1u);
  EXPECT_NEAR(area_mm2(sheet->mesh), 200.0, 1e-9);
}

TEST(SheetRepair, AMeshWithoutAreaIsRefused) {
  TriangleMesh point{Points::Zero(3, 3), Faces(1, 3)};
  point.faces << 0, 1, 2;
  EXPECT_EQ(repaired_sheet(point, 1).errors()[0].code, ErrorCode::BadGeometry);
  point.vertices_mm.row(1) << 1.0, 0.0, 0.0;
  point.vertices_mm.row(2) << 2.0, 0.0, 0.0;
  EXPECT_EQ(repaired_sheet(point, 1).errors()[0].code, ErrorCode::BadGeometry);
}

}  // namespace
}  // namespace coapt
