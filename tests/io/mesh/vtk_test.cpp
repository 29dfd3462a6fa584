#include "io/mesh/vtk.h"

#include <gtest/gtest.h>

#include "io/mesh/mesh_file.h"
#include "io/mesh/write_vtk.h"

namespace coapt {
namespace {

/// A triangle and a chorda of two pieces that hangs on its second vertex.
VtkPolyData triangle_and_chorda() {
  VtkPolyData data{"a title", Points(5, 3), {{3, 4}, {4, 1}}, Faces(1, 3), {}, {}, {}};
  data.points_mm << 0.0, 0.0, 0.0, 1.0 / 3.0, 0.0, 0.0, 0.0, 1.0, 0.0, 5.0, 5.0, -20.0, 2.0, 2.0,
      -9.0;
  data.faces << 0, 1, 2;
  data.line_data = {{"kind", {0.0, 3.0}, true}, {"rest_length_mm", {11.5, 9.25}}};
  data.face_data = {{"segment", {4.0}, true}, {"kind", {7.0}, true}};
  data.point_data = {{"height_mm", {0.0, 0.5, -0.5, 1e-9, 2.0}}};
  return data;
}

constexpr const char* kText =
    "# vtk DataFile Version 4.2\n"
    "a title\n"
    "ASCII\n"
    "DATASET POLYDATA\n"
    "POINTS 5 double\n"
    "0 0 0\n"
    "0.333333333 0 0\n"
    "0 1 0\n"
    "5 5 -20\n"
    "2 2 -9\n"
    "LINES   2 6\n"
    "2 3 4\n"
    "2 4 1\n"
    "POLYGONS 1 4\n"
    "3 0 1 2\n"
    "CELL_DATA 3\n"
    "SCALARS kind int 1\n"
    "LOOKUP_TABLE default\n"
    "0\n"
    "3\n"
    "7\n"
    "SCALARS rest_length_mm double 1\n"
    "LOOKUP_TABLE default\n"
    "11.5\n"
    "9.25\n"
    "0\n"
    "SCALARS segment int 1\n"
    "LOOKUP_TABLE default\n"
    "-1\n"
    "-1\n"
    "4\n"
    "POINT_DATA 5\n"
    "SCALARS height_mm double 1\n"
    "LOOKUP_TABLE default\n"
    "0\n"
    "0.5\n"
    "-0.5\n"
    "1e-09\n"
    "2\n";

VtkPolyData read(std::string_view text) {
  const Expected<VtkPolyData> data = read_vtk(text);
  EXPECT_TRUE(data) << data.errors()[0].path << ": " << data.errors()[0].message;
  return data ? *data : VtkPolyData{};
}

Error problem(std::string_view text) {
  const Expected<VtkPolyData> data = read_vtk(text);
  EXPECT_FALSE(data) << "was read";
  return data ? Error{} : data.errors()[0];
}

TEST(Vtk, LinesAndTrianglesWithDataAreThisText) {
  EXPECT_EQ(write_vtk(triangle_and_chorda()), kText);
}

TEST(Vtk, WhatIsWrittenIsReadBack) {
  const VtkPolyData data = read(kText);
  EXPECT_EQ(data.title, "a title");
  EXPECT_EQ(data.lines, (std::vector<std::array<int, 2>>{{3, 4}, {4, 1}}));
  EXPECT_EQ(data.faces, triangle_and_chorda().faces);
  EXPECT_EQ(data.points_mm(4, 2), -9.0);
  ASSERT_EQ(data.line_data.size(), 3U);
  EXPECT_EQ(data.line_data[1].name, "rest_length_mm");
  EXPECT_EQ(data.line_data[1].values, (std::vector<double>{11.5, 9.25}));
}

TEST(Vtk, VersionFiveWithOffsetsMetadataAndFieldsIsRead) {
  const VtkPolyData data = read(
      "# vtk DataFile Version 5.1\nParaView; SPACE=RAS\nASCII\nDATASET POLYDATA\n"
      "POINTS 4 float\n0 0 0 1 0 0 1 1 0\n0 1 0 \n\nMETADATA\nINFORMATION 1\nNAME L2\nDATA 0\n\n"
      "LINES 3 5\nOFFSETS vtktypeint64\n0 2 5 \nCONNECTIVITY vtktypeint64\n0 1 1 2 3 \n"
      "POLYGONS 2 4\nOFFSETS vtktypeint64\n0 4 \nCONNECTIVITY vtktypeint64\n0 1 2 3 \n"
      "CELL_DATA 3\nNORMALS n float\n0 0 1 0 0 1 0 0 1\nFIELD FieldData 2\n"
      "vectors 3 3 double\n1 2 3 4 5 6 7 8 9\nrest_length_mm 1 3 double\n1.5 2.5 0\n"
      "METADATA\nINFORMATION 0\n\n");
  EXPECT_EQ(data.points_mm.rows(), 4);
  EXPECT_EQ(data.faces.rows(), 2);  // a quad is two triangles
  EXPECT_EQ(data.lines, (std::vector<std::array<int, 2>>{{0, 1}, {1, 2}, {2, 3}}));
  ASSERT_EQ(data.line_data.size(), 1U);
  EXPECT_EQ(data.line_data[0].values, (std::vector<double>{1.5, 2.5, 2.5}));
}

TEST(Vtk, AStripIsTrianglesThatFaceOneSide) {
  const VtkPolyData data = read(
      "# vtk DataFile Version 3.0\nt\nASCII\nDATASET POLYDATA\nPOINTS 4 float\n0 0 0\n1 0 0\n0 1 "
      "0\n"
      "1 1 0\nTRIANGLE_STRIPS 1 5\n4 0 1 2 3\n");
  ASSERT_EQ(data.faces.rows(), 2);
  for (const auto& face : data.faces.rowwise()) {
    const Vec3 a = data.points_mm.row(face[0]), b = data.points_mm.row(face[1]),
               c = data.points_mm.row(face[2]);
    EXPECT_GT((b - a).cross(c - a).z(), 0.0);
  }
}

TEST(Vtk, ASectionMayBeEmptyAtTheEnd) {
  EXPECT_EQ(read(std::string(kText) + "VERTICES 0 0\n").faces.rows(), 1);
}

TEST(Vtk, LeafletsAreReadAsAMesh) {
  const Expected<TriangleMesh> mesh = read_mesh(kText, "vtk");
  ASSERT_TRUE(mesh);
  EXPECT_EQ(mesh->faces.rows(), 1);
  const VtkPolyData lines = read(
      "# vtk DataFile Version 4.2\nt\nASCII\nDATASET POLYDATA\nPOINTS 2 float\n0 0 0 1 1 1\n"
      "LINES 1 3\n2 0 1\n");
  EXPECT_EQ(lines.faces.rows(), 0);
  EXPECT_FALSE(read_mesh(write_vtk(lines), "vtk"));
}

TEST(Vtk, WhatIsWrongIsToldWithItsLine) {
  const std::string start = "# vtk DataFile Version 4.2\nt\nASCII\nDATASET POLYDATA\n";
  EXPECT_EQ(problem("solid").code, ErrorCode::InputOutput);
  EXPECT_EQ(problem("# vtk DataFile Version 4.2\nt\nPACKED\nDATASET POLYDATA\n").code,
            ErrorCode::Unsupported);
  EXPECT_EQ(problem("# vtk DataFile Version 4.2\nt\nASCII\nDATASET STRUCTURED_POINTS\n").code,
            ErrorCode::Unsupported);
  const Error word = problem(start + "POINTS 1 float\n0 x 0\n");
  EXPECT_EQ(word.path, "/vertices_mm/0");
  EXPECT_EQ(word.message.substr(0, 7), "line 6:");
  EXPECT_EQ(problem(start + "POINTS 2 float\n0 0 0\n").message, "line 6: is truncated");
  EXPECT_EQ(problem(start + "POINTS 1 float\n0 0 0\nLINES 1 3\n2 0 1\n").path, "/lines/0");
  EXPECT_EQ(problem(start + "POINTS 1 float\n0 0 0\nPOLYGONS 1 4\n3 0 0 9\n").path, "/faces/0/2");
  EXPECT_EQ(
      problem(start + "POINTS 1 float\n0 0 0\nLINES 2 2\nOFFSETS a\n0 7\nCONNECTIVITY a\n0 0\n")
          .code,
      ErrorCode::BadReference);
  EXPECT_EQ(problem(start + "POINTS 99999999999 float\n").path, "/vertices_mm");
  EXPECT_EQ(problem(std::string(kText) + "CELL_DATA 3\nSCALARS a int 9000000000000000000\n").path,
            "/data");
  EXPECT_EQ(problem(start + "SURPRISE 1\n").code, ErrorCode::Unsupported);
  EXPECT_EQ(problem(start + "POINTS 1 float\n1e9 0 0\nLINES 1 3\n2 0 0\n").code,
            ErrorCode::OutOfRange);
}

}  // namespace
}  // namespace coapt
