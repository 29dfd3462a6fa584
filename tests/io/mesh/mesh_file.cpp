#include "io/mesh/mesh_file.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <limits>
#include <optional>
#include <string>
#include <utility>

namespace coapt {
namespace {

// A square of two triangles, its corners in the order in which the triangles name them.
constexpr std::array<std::array<float, 3>, 4> kCorners = {
    {{0.0F, 0.0F, 0.0F}, {1.5F, 0.0F, 0.0F}, {0.0F, 1.5F, -2.0F}, {1.5F, 1.5F, -2.0F}}};
constexpr std::array<std::array<int, 3>, 2> kTriangles = {{{0, 1, 2}, {2, 1, 3}}};

void expect_square(std::string_view bytes, std::string_view format) {
  const Expected<TriangleMesh> mesh = read_mesh(bytes, format);
  ASSERT_TRUE(mesh) << mesh.errors()[0].path << ": " << mesh.errors()[0].message;
  ASSERT_EQ(mesh->vertices_mm.rows(), 4);
  ASSERT_EQ(mesh->faces.rows(), 2);
  for (int i = 0; i < 4; ++i) {
    for (int k = 0; k < 3; ++k) {
      EXPECT_EQ(mesh->vertices_mm(i, k),
                kCorners[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)]);
    }
  }
  for (int f = 0; f < 2; ++f) {
    for (int k = 0; k < 3; ++k) {
      EXPECT_EQ(mesh->faces(f, k),
                kTriangles[static_cast<std::size_t>(f)][static_cast<std::size_t>(k)]);
    }
  }
}

template <class T>
void append(std::string& bytes, T value, std::endian order) {
  char raw[sizeof(T)];
  std::memcpy(raw, &value, sizeof(T));
  if (order != std::endian::native) std::reverse(std::begin(raw), std::end(raw));
  bytes.append(raw, sizeof(T));
}

std::string binary_ply(std::endian order) {
  std::string bytes =
      std::string("ply\nformat ") +
      (order == std::endian::big ? "binary_big_endian" : "binary_little_endian") +
      " 1.0\ncomment by hand\nelement vertex 4\nproperty float x\nproperty float y\n"
      "property uchar red\nproperty float z\nelement face 2\n"
      "property list uchar int vertex_indices\nend_header\n";
  for (const auto& corner : kCorners) {
    append(bytes, corner[0], order);
    append(bytes, corner[1], order);
    append(bytes, std::uint8_t{200}, order);
    append(bytes, corner[2], order);
  }
  for (const auto& triangle : kTriangles) {
    append(bytes, std::uint8_t{3}, order);
    for (const int corner : triangle) append(bytes, std::int32_t{corner}, order);
  }
  return bytes;
}

std::string binary_stl(std::uint32_t announced) {
  std::string bytes(80, ' ');
  bytes.replace(0, 5, "solid");
  append(bytes, announced, std::endian::little);
  for (const auto& triangle : kTriangles) {
    for (int i = 0; i < 3; ++i) append(bytes, 0.0F, std::endian::little);
    for (const int corner : triangle) {
      for (const float x : kCorners[static_cast<std::size_t>(corner)])
        append(bytes, x, std::endian::little);
    }
    append(bytes, std::uint16_t{0}, std::endian::little);
  }
  return bytes;
}

constexpr const char* kObj =
    "# by hand\r\nv 0 0 0\r\nv 1.5 0 0\r\nv 0 1.5 -2\r\nv 1.5 1.5 -2\r\nvn 0 0 1\r\n"
    "f 1/1/1 2/2/1 3/3/1\r\nf -2//1 -3//1 -1//1\r\n";

constexpr const char* kAsciiPly =
    "ply\nformat ascii 1.0\nelement vertex 4\nproperty double x\nproperty double y\n"
    "property double z\nelement face 2\nproperty list uchar uint vertex_index\nend_header\n"
    "0 0 0\n1.5 0 0\n0 1.5 -2\n1.5 1.5 -2\n3 0 1 2\n3 2 1 3\n";

constexpr const char* kAsciiStl =
    "solid square\n facet normal 0 0 1\n  outer loop\n   vertex 0 0 0\n   vertex 1.5 0 0\n"
    "   vertex 0 1.5 -2\n  endloop\n endfacet\n facet normal 0 0 1\n  outer loop\n"
    "   vertex 0 1.5 -2\n   vertex 1.5 0 0\n   vertex 1.5 1.5 -2\n  endloop\n endfacet\nendsolid "
    "square\n";

/// The first problem of a file that must have one.
Error problem(std::string_view bytes, std::string_view format) {
  const Expected<TriangleMesh> mesh = read_mesh(bytes, format);
  EXPECT_FALSE(mesh) << "was read";
  return mesh ? Error{} : mesh.errors().front();
}

TEST(MeshFile, TheSameMeshIsReadFromEveryFormat) {
  expect_square(kObj, "obj");
  expect_square(kAsciiPly, "ply");
  expect_square(binary_ply(std::endian::little), "ply");
  expect_square(binary_ply(std::endian::big), "ply");
  expect_square(kAsciiStl, "stl");
  expect_square(binary_stl(2), "stl");
}

TEST(MeshFile, PolygonsAreSplitIntoFans) {
  const auto mesh = read_mesh("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n", "obj");
  ASSERT_TRUE(mesh);
  ASSERT_EQ(mesh->faces.rows(), 2);
  EXPECT_EQ(mesh->faces.row(0), Eigen::RowVector3i(0, 1, 2));
  EXPECT_EQ(mesh->faces.row(1), Eigen::RowVector3i(0, 2, 3));
}

TEST(MeshFile, MoreVerticesOrTrianglesThanAcceptedAreRefusedInEveryFormat) {
  const std::string vtk =
      "# vtk DataFile Version 4.2\nsquare\nASCII\nDATASET POLYDATA\nPOINTS 4 double\n0 0 0\n1 0 "
      "0\n1 "
      "1 0\n0 1 0\nPOLYGONS 1 5\n4 0 1 2 3\n";
  const std::string vtp =
      "<VTKFile type=\"PolyData\" byte_order=\"LittleEndian\"><PolyData><Piece><Points><DataArray "
      "type=\"Float64\" format=\"ascii\">0 0 0 1 0 0 1 1 0 0 1 0</DataArray></Points><Polys>"
      "<DataArray type=\"Int32\" Name=\"connectivity\" format=\"ascii\">0 1 2 3</DataArray>"
      "<DataArray type=\"Int32\" Name=\"offsets\" format=\"ascii\">4</DataArray></Polys></Piece>"
      "</PolyData></VTKFile>";
  const std::pair<std::string, std::string> files[] = {
      {kObj, "obj"},      {kAsciiPly, "ply"},     {binary_ply(std::endian::big), "ply"},
      {kAsciiStl, "stl"}, {binary_stl(2), "stl"}, {vtk, "vtk"},
      {vtp, "vtp"}};
  for (const auto& [bytes, format] : files) {
    const auto message = [&, &bytes = bytes, &format = format](const MeshLimits& limits) {
      const auto mesh = read_mesh(bytes, format, kMostUnpackedSent, limits);
      return mesh ? std::string() : mesh.errors().front().message;
    };
    EXPECT_EQ(message({4, 2}), "") << format;
    EXPECT_NE(message({3, 2}).find("more than the 3 vertices accepted"), std::string::npos)
        << format << ": " << message({3, 2});
    EXPECT_NE(message({4, 1}).find("more than the 1 triangles accepted"), std::string::npos)
        << format << ": " << message({4, 1});
  }
}

TEST(MeshFile, AnObjFileHasNoMoreLinesOrNamesThanTriangles) {
  const auto code = [](const std::string& text) {
    const auto mesh =
        read_mesh("v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n" + text, "obj", kMostUnpackedSent, {10, 3});
    return mesh ? std::optional<ErrorCode>() : mesh.errors().front().code;
  };
  EXPECT_EQ(code("l 1 2\nl 2 3\nl 3 1\n"), std::nullopt);
  EXPECT_EQ(code("l 1 2\nl 2 3\nl 3 1\nl 1 2\n# end\n"), ErrorCode::OutOfRange);
  EXPECT_EQ(code("g a\ng b\ng c\ng d\n# end\n"), ErrorCode::OutOfRange);
}

TEST(MeshFile, ATriangleThatNamesAVertexTwiceIsLeftOut) {
  const auto mesh = read_mesh("v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 2\nf 1 2 3\n", "obj");
  ASSERT_TRUE(mesh);
  EXPECT_EQ(mesh->faces.rows(), 1);
}

TEST(MeshFile, AnIndexOutOfRangeIsNamedWithItsLine) {
  const Error error = problem("v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 9\n", "obj");
  EXPECT_EQ(error.code, ErrorCode::BadReference);
  EXPECT_EQ(error.path, "/faces/0/2");
  EXPECT_EQ(error.message, "line 4: is vertex 8 counted from 0, must be 0 to 2");
}

TEST(MeshFile, WhatPointsOfNoTriangleHoldDoesNotMatter) {
  for (const char* wild : {"v nan inf 0\n", "v 1e30 0 0\n"}) {
    EXPECT_TRUE(read_mesh(std::string("v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n") + wild, "obj"));
    EXPECT_EQ(problem(std::string("v 0 0 0\nv 1 0 0\n") + wild + "f 1 2 3\n", "obj").code,
              ErrorCode::OutOfRange);
  }
  EXPECT_EQ(problem("solid x\nfacet\nvertex 0 0 0\nvertex nan 0 0\nvertex 0 1 0\nendfacet\n"
                    "endsolid x\n",
                    "stl")
                .path,
            "/vertices_mm/1/0");
}

TEST(MeshFile, NotANumberIsNamedWithItsLine) {
  const Error error = problem("v 0 0 0\nv 1 nan 0\nv 1 1 0\nf 1 2 3\n", "obj");
  EXPECT_EQ(error.code, ErrorCode::OutOfRange);
  EXPECT_EQ(error.path, "/vertices_mm/1/1");
  EXPECT_TRUE(error.message.starts_with("line 2: ")) << error.message;
  EXPECT_EQ(problem("v 0 zero 0\n", "obj").code, ErrorCode::WrongType);
  EXPECT_EQ(problem("v 0 0\n", "obj").code, ErrorCode::WrongType);
}

TEST(MeshFile, EveryProblemIsListed) {
  const auto mesh = read_mesh("v 0 0 inf\nv 1 x 0\nf 1 2 7\nf 0 1 2\n", "obj");
  ASSERT_FALSE(mesh);
  EXPECT_EQ(mesh.errors().size(), 4U);
}

TEST(MeshFile, ABinaryCountThatTheBytesDoNotHoldIsRefused) {
  EXPECT_EQ(problem(binary_stl(std::numeric_limits<std::uint32_t>::max()), "stl").code,
            ErrorCode::InputOutput);
  std::string ply = binary_ply(std::endian::little);
  ply.replace(ply.find("vertex 4"), 8, "vertex 2147483647");
  EXPECT_EQ(problem(ply, "ply").code, ErrorCode::InputOutput);
  ply.replace(ply.find("2147483647"), 10, "9999999999");
  EXPECT_EQ(problem(ply, "ply").code, ErrorCode::Unsupported);
  ply.replace(ply.find("9999999999"), 10, "-1");
  EXPECT_EQ(problem(ply, "ply").code, ErrorCode::Unsupported);
}

TEST(MeshFile, APlyListLongerThanTheFileIsRefused) {
  std::string ply = kAsciiPly;
  ply.replace(ply.find("3 2 1 3"), 7, "4000000000 2 1 3");
  EXPECT_EQ(problem(ply, "ply").code, ErrorCode::InputOutput);
  ply = kAsciiPly;
  ply.replace(ply.find("3 2 1 3"), 7, "2 2 1");
  EXPECT_EQ(problem(ply, "ply").path, "/faces/1");
}

TEST(MeshFile, AFileCutShortAnywhereIsRefused) {
  const std::string whole[] = {binary_ply(std::endian::little), binary_ply(std::endian::big),
                               binary_stl(2)};
  for (const std::string& bytes : whole) {
    const char* const format = bytes.starts_with("ply") ? "ply" : "stl";
    for (std::size_t length = 0; length < bytes.size(); ++length) {
      EXPECT_FALSE(read_mesh(std::string_view(bytes).substr(0, length), format)) << length;
    }
  }
}

TEST(MeshFile, ADamagedByteNeverBreaksTheReader) {
  for (const auto order : {std::endian::little, std::endian::big}) {
    const std::string whole = binary_ply(order);
    for (std::size_t i = 0; i < whole.size(); ++i) {
      for (const char damage : {'\0', '\x7f', '\xff', ' ', '9'}) {
        std::string bytes = whole;
        bytes[i] = damage;
        const auto mesh = read_mesh(bytes, "ply");
        if (!mesh) continue;
        EXPECT_TRUE(mesh->vertices_mm.allFinite());
        EXPECT_LT(mesh->faces.maxCoeff(), mesh->vertices_mm.rows());
      }
    }
  }
}

TEST(MeshFile, WhatIsNoMeshIsRefused) {
  EXPECT_EQ(problem("", "obj").code, ErrorCode::MissingField);
  EXPECT_EQ(problem("v 0 0 0\n", "obj").code, ErrorCode::MissingField);
  EXPECT_EQ(problem("", "ply").code, ErrorCode::InputOutput);
  EXPECT_EQ(problem("", "stl").code, ErrorCode::InputOutput);
  EXPECT_EQ(problem("solid x\n facet\n vertex 0 0 0\n endfacet\n", "stl").code,
            ErrorCode::WrongType);
  EXPECT_EQ(problem(kObj, "glb").code, ErrorCode::InvalidJson);
  EXPECT_EQ(problem(kObj, "fbx").code, ErrorCode::Unsupported);
}

TEST(MeshFile, APlyWithoutCoordinatesOrFacesIsRefused) {
  std::string ply = kAsciiPly;
  ply.replace(ply.find("double z"), 8, "double w");
  EXPECT_EQ(problem(ply, "ply").code, ErrorCode::MissingField);
  ply = kAsciiPly;
  ply.replace(ply.find("vertex_index"), 12, "corner_index");
  EXPECT_EQ(problem(ply, "ply").path, "/faces");
}

}  // namespace
}  // namespace coapt
