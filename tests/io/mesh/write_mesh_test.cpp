#include "io/mesh/write_mesh.h"

#include <gtest/gtest.h>

#include <clocale>
#include <cmath>
#include <limits>
#include <sstream>

namespace coapt {
namespace {

constexpr const char* kFormats[] = {"ply", "obj", "stl", "vtk"};

/// Two triangles; what single precision and %.9g round, and what they do not.
TriangleMesh square() {
  TriangleMesh mesh{Points(4, 3), Faces(2, 3)};
  mesh.vertices_mm << 0.0, -0.0, 1.0 / 3.0, 1.5, 1e-300, 12.0, 0.1, 99999.123456789012, -2.0, 1.5,
      1.5, -2.0;
  mesh.faces << 0, 1, 2, 2, 1, 3;
  return mesh;
}

std::string written(const TriangleMesh& mesh, std::string_view format) {
  const Expected<std::string> bytes = write_mesh(mesh, format);
  EXPECT_TRUE(bytes) << bytes.errors()[0].message;
  return bytes ? *bytes : "";
}

TriangleMesh round_trip(const TriangleMesh& mesh, std::string_view format) {
  const Expected<TriangleMesh> read = read_mesh(written(mesh, format), format);
  EXPECT_TRUE(read) << read.errors()[0].message;
  return read ? *read : TriangleMesh{};
}

TEST(WriteMesh, PlyAndObjReadBackBitForBit) {
  const TriangleMesh mesh = square();
  for (const char* format : {"ply", "obj"}) {
    const TriangleMesh read = round_trip(mesh, format);
    EXPECT_EQ(read.vertices_mm, mesh.vertices_mm) << format;
    EXPECT_EQ(read.faces, mesh.faces) << format;
    EXPECT_TRUE(std::signbit(read.vertices_mm(0, 1)));
  }
}

TEST(WriteMesh, StlReadsBackInSinglePrecision) {
  const TriangleMesh mesh = square();
  const TriangleMesh read = round_trip(mesh, "stl");
  EXPECT_EQ(read.vertices_mm, mesh.vertices_mm.cast<float>().cast<double>());
  EXPECT_EQ(read.faces, mesh.faces);  // they name the vertices in order, so the order comes back
}

TEST(WriteMesh, StlIsBinaryWithUnitNormalsThatAgreeWithTheWinding) {
  TriangleMesh mesh{Points(3, 3), Faces(2, 3)};
  mesh.vertices_mm << 0.0, 0.0, 5.0, 3.0, 0.0, 5.0, 0.0, 7.0, 5.0;
  mesh.faces << 0, 1, 2, 1, 1, 2;  // the second has no area
  const std::string bytes = written(mesh, "stl");
  ASSERT_EQ(bytes.size(), 80u + 4u + 2u * 50u);
  EXPECT_FALSE(bytes.starts_with("solid"));
  EXPECT_EQ(bytes.substr(80, 4), std::string("\2\0\0\0", 4));
  EXPECT_EQ(bytes.substr(84, 12), std::string("\0\0\0\0\0\0\0\0\0\0\x80\x3f", 12));  // 0 0 1
  EXPECT_EQ(bytes.substr(134, 12), std::string(12, '\0'));
}

TEST(WriteMesh, VtkIsThisText) {
  EXPECT_EQ(written(square(), "vtk"),
            "# vtk DataFile Version 4.2\n"
            "coapt: research software, not a medical device; millimetres, axes of the valve; "
            "SPACE=LPS\n"
            "ASCII\n"
            "DATASET POLYDATA\n"
            "POINTS 4 double\n"
            "0 -0 0.333333333\n"
            "1.5 1e-300 12\n"
            "0.1 99999.1235 -2\n"
            "1.5 1.5 -2\n"
            "POLYGONS 2 8\n"
            "3 0 1 2\n"
            "3 2 1 3\n");
}

TEST(WriteMesh, LinesAreShort) {
  TriangleMesh mesh = square();
  mesh.vertices_mm.fill(-1.2345678901234567e-300);
  for (const char* format : {"ply", "obj", "vtk"}) {
    std::istringstream lines(written(mesh, format));
    for (std::string line; std::getline(lines, line);) EXPECT_LT(line.size(), 255u);
  }
}

TEST(WriteMesh, TheLocaleChangesNothing) {
  const std::string before = std::setlocale(LC_ALL, nullptr);
  for (const char* format : kFormats) {
    const std::string plain = written(square(), format);
    for (const char* locale : {"de_DE.UTF-8", "fr_FR.UTF-8", "C.UTF-8"}) {
      std::setlocale(LC_ALL, locale);  // where it is not installed this changes nothing
      EXPECT_EQ(written(square(), format), plain);
    }
    std::setlocale(LC_ALL, before.c_str());
  }
}

TEST(WriteMesh, TheLeafletsOfAValveAreItsFacesWhereTheyAreClosed) {
  Valve valve;
  valve.rest_mm = square().vertices_mm;
  valve.faces = square().faces;
  const Points closed_mm = 2.0 * valve.rest_mm.array() + 1.0;
  const TriangleMesh leaflets = leaflet_mesh(valve, closed_mm);
  EXPECT_EQ(leaflets.vertices_mm, closed_mm);
  EXPECT_EQ(leaflets.faces, valve.faces);
}

TEST(WriteMesh, WhatNoReaderTakesIsRefusedWithItsPlace) {
  TriangleMesh mesh = square();
  mesh.vertices_mm(1, 2) = std::numeric_limits<double>::quiet_NaN();
  mesh.vertices_mm(3, 0) = -1e30;
  mesh.faces(1, 1) = 4;
  mesh.faces(0, 0) = -1;
  for (const char* format : kFormats) {
    const Expected<std::string> bytes = write_mesh(mesh, format);
    ASSERT_FALSE(bytes);
    ASSERT_EQ(bytes.errors().size(), 4u);
    EXPECT_EQ(bytes.errors()[0].code, ErrorCode::OutOfRange);
    EXPECT_EQ(bytes.errors()[0].path, "/vertices_mm/1/2");
    EXPECT_EQ(bytes.errors()[1].path, "/vertices_mm/3/0");
    EXPECT_EQ(bytes.errors()[2].code, ErrorCode::BadReference);
    EXPECT_EQ(bytes.errors()[2].path, "/faces/0/0");
    EXPECT_EQ(bytes.errors()[3].path, "/faces/1/1");
  }
  const Expected<std::string> bytes = write_mesh(square(), "glb");
  ASSERT_FALSE(bytes);
  EXPECT_EQ(bytes.errors()[0].code, ErrorCode::Unsupported);
}

}  // namespace
}  // namespace coapt
