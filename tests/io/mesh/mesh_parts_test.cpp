#include "io/mesh/mesh_parts.h"

#include <gtest/gtest.h>

namespace coapt {
namespace {

const std::string kPoints = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 5 0 0\nv 6 0 0\nv 5 1 0\n";

MeshParts parts_of(const std::string& text, const std::string& format) {
  Expected<MeshParts> parts = read_mesh_parts(text, format, true);
  EXPECT_TRUE(parts) << text << (parts ? "" : parts.errors()[0].message);
  return parts ? *std::move(parts) : MeshParts{};
}

TEST(MeshParts, ObjectsGroupsOrMaterialsOfObjTheFirstThatDiffer) {
  for (const char* keyword : {"o", "g", "usemtl"}) {
    const std::string word(keyword);
    const MeshParts parts =
        parts_of(kPoints + word + " ANTERIOR LEAFLET\r\nf 1 2 3\r\n" + word +
                     " POSTERIOR\r\nf 4 5 6\r\n" + word + " ring\r\nl 1 2 3 4\r\nl 4 1\r\n",
                 "obj");
    ASSERT_EQ(parts.parts.size(), 3U) << word;
    EXPECT_EQ(parts.parts[0].name, "ANTERIOR LEAFLET");
    EXPECT_EQ(parts.parts[0].mesh.vertices_mm.rows(), 3);
    EXPECT_EQ(parts.parts[1].mesh.vertices_mm(0, 0), 5.0);
    EXPECT_EQ(parts.parts[2].mesh.faces.rows(), 0);
    EXPECT_EQ(parts.parts[2].line_mm.rows(), 4);
  }
}

TEST(MeshParts, WithoutNamesPiecesThatDoNotHangTogether) {
  EXPECT_EQ(parts_of(kPoints + "f 1 2 3\nf 4 5 6\n", "obj").parts.size(), 2U);
  EXPECT_EQ(parts_of(kPoints + "o a\nf 1 2 3\nf 3 2 4\nf 3 4 6\n", "obj").parts.size(), 1U);
}

TEST(MeshParts, SolidsOfStl) {
  const std::string facet =
      "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n"
      "endfacet\n";
  std::string other = facet;
  other.replace(other.find("vertex 0 0 0"), 12, "vertex 0 1 1");
  const MeshParts parts = parts_of(
      "solid anterior\n" + facet + "endsolid\nsolid posterior\n" + other + "endsolid\n", "stl");
  ASSERT_EQ(parts.parts.size(), 2U);
  EXPECT_EQ(parts.parts[1].name, "posterior");
}

std::string vtk(const std::string& cells, const std::string& dataset = "POLYDATA") {
  return "# vtk DataFile Version 3.0\nx\nASCII\nDATASET " + dataset +
         "\nPOINTS 5 float\n0 0 0 1 0 0 0 1 0 1 1 0 2 0 0\n" + cells;
}

TEST(MeshParts, AnArrayOfCellsThatNumbersLeaflets) {
  const std::string cells = "POLYGONS 2 8\n3 0 1 2\n3 1 3 2\nCELL_DATA 2\n";
  for (const char* name : {"leaflet", "RegionId", "Label"}) {
    const MeshParts parts =
        parts_of(vtk(cells + "SCALARS " + name + " int 1\nLOOKUP_TABLE default\n3 7\n"), "vtk");
    EXPECT_EQ(parts.parts.size(), 2U) << name;
  }
  for (const char* other : {"SCALARS strain float 1\nLOOKUP_TABLE default\n3 7\n",
                            "SCALARS leaflet int 1\nLOOKUP_TABLE default\n7 7\n"})
    EXPECT_EQ(parts_of(vtk(cells + other), "vtk").parts.size(), 1U) << other;
}

TEST(MeshParts, AnArrayOfPointsThatNumbersLeafletsGivesATriangleThePartOfMostCorners) {
  const std::string cells = "POLYGONS 2 8\n3 0 1 2\n3 1 3 4\nPOINT_DATA 5\n";
  const MeshParts parts =
      parts_of(vtk(cells + "SCALARS PartId float 1\nLOOKUP_TABLE default\n1 1 2 2 2\n"), "vtk");
  ASSERT_EQ(parts.parts.size(), 2U);
  EXPECT_EQ(parts.told_apart_by, "the array partid of the points");
  EXPECT_EQ(parts.parts[0].mesh.faces.rows(), 1);
  EXPECT_EQ(parts.parts[1].name, "number 2");
  EXPECT_NE(
      parts_of(vtk(cells + "SCALARS leaflet float 1\nLOOKUP_TABLE default\n0 0.5 1 1 1\n"), "vtk")
          .told_apart_by,
      "the array leaflet of the points");
}

TEST(MeshParts, WholeNumbersOfFacesInPlyNumberLeafletsAndTheRestIsLeftOver) {
  const auto ply = [](const std::string& property) {
    return "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty "
           "float "
           "z\nelement face 2\nproperty uchar flags\nproperty list uchar int vertex_indices\n" +
           property + "\nend_header\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n9 3 0 1 2 4\n9 3 1 3 2 7\n";
  };
  for (const char* name : {"label", "leaflet", "segment", "material_index"}) {
    const MeshParts parts = parts_of(ply(std::string("property int ") + name), "ply");
    ASSERT_EQ(parts.parts.size(), 2U) << name;
    EXPECT_EQ(parts.parts[1].name, "number 7");
    EXPECT_EQ(parts.arrays.names, (std::vector<std::string>{"flags"}));
    EXPECT_EQ(parts.arrays.of, 2U);
  }
  EXPECT_EQ(parts_of(ply("property float label"), "ply").parts.size(), 1U);
}

TEST(MeshParts, ALineOfAFileIsALoopOfItsPointsInOrder) {
  const Expected<Points> obj = read_mesh_line(kPoints + "l 3 4\nl 1 2\nl 2 3\nl 4 1\n", "obj");
  ASSERT_TRUE(obj);
  ASSERT_EQ(obj->rows(), 4);
  EXPECT_EQ(obj->row(1), Eigen::RowVector3d(1, 0, 0));
  const Expected<Points> lines = read_mesh_line(vtk("LINES 1 6\n5 0 1 3 2 0\n"), "vtk");
  ASSERT_TRUE(lines);
  EXPECT_EQ(lines->rows(), 4);
  EXPECT_EQ(read_mesh_line(kPoints + "l 1 2\nl 3 4\n", "obj").errors()[0].path, "/lines");
  EXPECT_EQ(read_mesh_line(kPoints + "f 1 2 3\n", "obj").errors()[0].code, ErrorCode::MissingField);
}

TEST(MeshParts, AnUnstructuredGridHasTheSameCells) {
  const Expected<MeshParts> grid =
      read_mesh_parts(vtk("CELLS 4 15\n3 0 1 2\n4 0 1 3 2\n2 3 4\n1 0\nCELL_TYPES 4\n5\n9\n3\n1\n",
                          "UNSTRUCTURED_GRID"),
                      "vtk", false);
  ASSERT_TRUE(grid) << grid.errors()[0].message;
  EXPECT_EQ(grid->parts[0].mesh.faces.rows(), 3);
  const Expected<MeshParts> solid = read_mesh_parts(
      vtk("CELLS 1 5\n4 0 1 2 3\nCELL_TYPES 1\n10\n", "UNSTRUCTURED_GRID"), "vtk", false);
  ASSERT_FALSE(solid);
  EXPECT_EQ(solid.errors()[0].code, ErrorCode::Unsupported);
  const Expected<MeshParts> short_of_types = read_mesh_parts(
      vtk("CELLS 2 8\n3 0 1 2\n3 1 3 2\nCELL_TYPES 1\n5\n", "UNSTRUCTURED_GRID"), "vtk", false);
  EXPECT_FALSE(short_of_types);
}

TEST(MeshParts, NumbersMayAllStandOnOneLine) {
  std::string points, cells;
  constexpr int kMany = 1200;
  for (int i = 0; i < kMany + 2; ++i)
    points += std::to_string(i) + ' ' + std::to_string(i % 2) + " 0 ";
  for (int i = 0; i < kMany; ++i)
    cells +=
        "3 " + std::to_string(i) + ' ' + std::to_string(i + 1) + ' ' + std::to_string(i + 2) + ' ';
  const Expected<MeshParts> parts =
      read_mesh_parts("# vtk DataFile Version 3.0\nx\nASCII\nDATASET POLYDATA\nPOINTS " +
                          std::to_string(kMany + 2) + " float " + points + "\nPOLYGONS " +
                          std::to_string(kMany) + ' ' + std::to_string(4 * kMany) + ' ' + cells,
                      "vtk", false);
  ASSERT_TRUE(parts) << parts.errors()[0].message;
  EXPECT_EQ(parts->parts[0].mesh.faces.rows(), kMany);
}

}  // namespace
}  // namespace coapt
