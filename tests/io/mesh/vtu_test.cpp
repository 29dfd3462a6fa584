#include "io/mesh/vtu.h"

#include <gtest/gtest.h>
#include <lzma.h>
#include <zlib.h>

#include <cstring>

#include "io/mesh/mesh_parts.h"

namespace coapt {
namespace {

Expected<VtuGrid> read_vtu_all(std::string_view bytes) {
  return read_vtu(bytes, [](std::string_view) { return true; });
}

enum class Packing { None, Zlib, Lzma };

template <class T>
std::string bytes_of(const std::vector<T>& numbers) {
  std::string bytes(numbers.size() * sizeof(T), '\0');
  std::memcpy(bytes.data(), numbers.data(), bytes.size());
  return bytes;
}

std::string in_base64(const std::string& bytes) {
  constexpr const char* kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t at = 0; at < bytes.size(); at += 3) {
    unsigned bits = 0;
    for (std::size_t k = 0; k < 3; ++k)
      bits = bits << 8 | (at + k < bytes.size() ? static_cast<unsigned char>(bytes[at + k]) : 0U);
    for (int k = 0; k < 4; ++k)
      text += at + static_cast<std::size_t>(k) > bytes.size() ? '='
                                                              : kDigits[bits >> (18 - 6 * k) & 63];
  }
  return text;
}

std::string packed(const std::string& bytes, Packing packing) {
  std::string out(1000 + 2 * bytes.size(), '\0');
  if (packing == Packing::Zlib) {
    uLongf size = out.size();
    compress(reinterpret_cast<Bytef*>(out.data()), &size,
             reinterpret_cast<const Bytef*>(bytes.data()), bytes.size());
    out.resize(size);
  } else {
    std::size_t size = 0;
    lzma_easy_buffer_encode(5, LZMA_CHECK_CRC32, nullptr,
                            reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size(),
                            reinterpret_cast<std::uint8_t*>(out.data()), &size, out.size());
    out.resize(size);
  }
  return out;
}

/// As VTK stores them: blocks of 16 bytes, counts of 8 bytes.
std::string stored(const std::string& bytes, Packing packing, bool raw) {
  const auto coded = [&](const std::string& part) { return raw ? part : in_base64(part); };
  if (packing == Packing::None)
    return coded(bytes_of(std::vector<std::uint64_t>{bytes.size()}) + bytes);
  constexpr std::size_t kBlock = 16;
  std::vector<std::uint64_t> head = {(bytes.size() + kBlock - 1) / kBlock, kBlock,
                                     bytes.size() % kBlock};
  std::string blocks;
  for (std::size_t at = 0; at < bytes.size(); at += kBlock) {
    const std::string block = packed(bytes.substr(at, kBlock), packing);
    head.push_back(block.size());
    blocks += block;
  }
  return coded(bytes_of(head)) + coded(blocks);
}

/// A quadrangle and a triangle beside it, a line, a label a cell and a displacement a point; arrays behind the elements.
std::string file_of(Packing packing, bool raw) {
  std::string appended;
  const auto array = [&](const std::string& attributes, const std::string& bytes) {
    const std::string element = "<DataArray " + attributes + " format=\"appended\" offset=\"" +
                                std::to_string(appended.size()) + "\"/>\n";
    appended += stored(bytes, packing, raw);
    return element;
  };
  const std::vector<float> points = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 2, 0.5F, 0};
  const std::string compressor = packing == Packing::None ? ""
                                 : packing == Packing::Zlib
                                     ? " compressor=\"vtkZLibDataCompressor\""
                                     : " compressor=\"vtkLZMADataCompressor\"";
  std::string text =
      "<?xml version=\"1.0\"?>\n<!-- of a test -->\n<VTKFile type=\"UnstructuredGrid\" "
      "version=\"1.0\" "
      "byte_order=\"LittleEndian\" header_type=\"UInt64\"" +
      compressor +
      ">\n<UnstructuredGrid>\n<Piece NumberOfPoints=\"5\" NumberOfCells=\"3\">\n<PointData>\n" +
      array("type=\"Float64\" Name=\"displacement\" NumberOfComponents=\"3\"",
            bytes_of(std::vector<double>(15, 0.25))) +
      "</PointData>\n<CellData>\n" +
      array("type=\"Int32\" Name=\"element_sets\"", bytes_of(std::vector<std::int32_t>{7, 8, 9})) +
      "</CellData>\n<Points>\n" +
      array("type=\"Float32\" Name=\"Points\" NumberOfComponents=\"3\"", bytes_of(points)) +
      "</Points>\n<Cells>\n" +
      array("type=\"Int64\" Name=\"connectivity\"",
            bytes_of(std::vector<std::int64_t>{3, 4, 0, 1, 2, 3, 1, 4, 2})) +
      array("type=\"Int64\" Name=\"offsets\"", bytes_of(std::vector<std::int64_t>{2, 6, 9})) +
      array("type=\"UInt8\" Name=\"types\"", bytes_of(std::vector<std::uint8_t>{3, 9, 5})) +
      "</Cells>\n</Piece>\n</UnstructuredGrid>\n<AppendedData encoding=\"" +
      (raw ? "raw" : "base64") + "\">\n_" + appended + "\n</AppendedData>\n</VTKFile>\n";
  return text;
}

void expect_quad_and_triangle(const Expected<VtuGrid>& grid) {
  ASSERT_TRUE(grid) << grid.errors()[0].path << ' ' << grid.errors()[0].message;
  ASSERT_EQ(grid->mesh.vertices_mm.rows(), 5);
  EXPECT_EQ(grid->mesh.vertices_mm(4, 1), 0.5);
  Faces faces(3, 3);
  faces << 0, 1, 2, 0, 2, 3, 1, 4, 2;
  EXPECT_EQ(grid->mesh.faces, faces);
  EXPECT_EQ(grid->mesh.polygons, (std::vector<int>{1, 1, 2}));
}

TEST(Vtu, IsReadRawAndInBase64PlainAndCompressed) {
  for (const Packing packing : {Packing::None, Packing::Zlib, Packing::Lzma})
    for (const bool raw : {false, true}) {
      const Expected<VtuGrid> grid = read_vtu_all(file_of(packing, raw));
      expect_quad_and_triangle(grid);
      ASSERT_EQ(grid->cell_data.size(), 1U);
      EXPECT_EQ(grid->cell_data[0].name, "element_sets");
      EXPECT_EQ(grid->cell_data[0].values, (std::vector<double>{7, 8, 9}));
      ASSERT_EQ(grid->point_data.size(), 1U);
      EXPECT_EQ(grid->point_data[0].components, 3);
      EXPECT_EQ(grid->point_data[0].values, std::vector<double>(15, 0.25));
    }
}

TEST(Vtu, IsReadWithNumbersInPlace) {
  expect_quad_and_triangle(read_vtu_all(
      "<VTKFile type='UnstructuredGrid'><UnstructuredGrid><Piece NumberOfPoints='5' "
      "NumberOfCells='3'><Points><DataArray type='Float32' format='ascii'>0 0 0 1 0 0\n1 1 0 0 1 0 "
      "2 "
      "0.5 0</DataArray></Points><Cells><DataArray type='Int64' Name='connectivity' "
      "format='ascii'>3 4 0 1 2 3 1 4 2</DataArray><DataArray type='Int64' Name='offsets' "
      "format='ascii'>2 6 9</DataArray><DataArray type='UInt8' Name='types' format='binary'>\n" +
      in_base64(bytes_of(std::vector<std::uint32_t>{3}) +
                bytes_of(std::vector<std::uint8_t>{3, 9, 5})) +
      "\n</DataArray></Cells></Piece></UnstructuredGrid></VTKFile>"));
}

TEST(Vtu, RefusesWhatItCannotReadAndSaysWhere) {
  const std::string good = file_of(Packing::Lzma, false);
  const auto refusal = [&](const std::string& from, const std::string& to) {
    std::string bad = good;
    bad.replace(bad.find(from), from.size(), to);
    const Expected<VtuGrid> grid = read_vtu_all(bad);
    EXPECT_FALSE(grid) << to;
    return grid ? Error{} : grid.errors().front();
  };
  EXPECT_EQ(refusal("VTKFile", "Other").code, ErrorCode::InputOutput);
  EXPECT_EQ(refusal("UnstructuredGrid", "PolyData").code, ErrorCode::Unsupported);
  EXPECT_EQ(refusal("LittleEndian", "BigEndian").code, ErrorCode::Unsupported);
  EXPECT_EQ(refusal("vtkLZMADataCompressor", "vtkLZ4DataCompressor").code, ErrorCode::Unsupported);
  EXPECT_EQ(refusal("Float32", "String_").path, "/vertices_mm");
  EXPECT_EQ(refusal("connectivity", "corners").path, "/cells/connectivity");
  EXPECT_EQ(refusal("base64\">\n_", "base64\">\n_!!!!").code, ErrorCode::InputOutput);
  EXPECT_EQ(refusal("<Piece", "<Piece/><Piece").code, ErrorCode::Unsupported);
  EXPECT_EQ(read_vtu_all("").errors().front().code, ErrorCode::InputOutput);
}

TEST(Vtu, CutShortAnywhereIsRefusedAndNeverRead) {
  for (const bool raw : {false, true}) {
    const std::string good = file_of(Packing::Zlib, raw);
    for (std::size_t size = 0; size + 40 < good.size(); size += 7)
      EXPECT_FALSE(read_vtu_all(std::string_view(good).substr(0, size))) << size;
  }
}

/// A .vtp of so many arrays at one place, which holds 8 MiB of zeros in as many blocks, packed into some kilobytes.
std::string bomb(int arrays, std::uint64_t blocks, const std::string& type = "Float64") {
  constexpr std::uint64_t kBlock = std::uint64_t{8} << 20;
  const std::string block = packed(std::string(kBlock, '\0'), Packing::Zlib);
  std::vector<std::uint64_t> head = {blocks, kBlock, 0};
  std::string body;
  for (std::uint64_t i = 0; i < blocks; ++i) {
    head.push_back(block.size());
    body += block;
  }
  std::string text =
      "<VTKFile type='PolyData' header_type='UInt64' compressor='vtkZLibDataCompressor'><PolyData>"
      "<Piece><Points><DataArray type='Float32' format='ascii'>0 0 0 1 0 0 0 1 0</DataArray>"
      "</Points><Polys><DataArray Name='connectivity' format='ascii'>0 1 2</DataArray><DataArray "
      "Name='offsets' format='ascii'>3</DataArray></Polys><PointData>";
  for (int i = 0; i < arrays; ++i)
    text += "<DataArray type='" + type + "' Name='a" + std::to_string(i) +
            "' format='appended' offset='0'/>";
  return text + "</PointData></Piece></PolyData><AppendedData encoding='raw'>_" + bytes_of(head) +
         body + "</AppendedData></VTKFile>";
}

TEST(Vtu, WhatUnpacksWithoutEndIsRefusedWithOneLimitForTheFile) {
  for (const auto& [arrays, blocks] : {std::pair{200, 1}, std::pair{1, 13}, std::pair{13, 1}}) {
    const std::string file = bomb(arrays, static_cast<std::uint64_t>(blocks));
    EXPECT_LT(file.size(), 150'000u);
    const Expected<VtuGrid> grid = read_vtp(file, [](std::string_view) { return true; });
    ASSERT_FALSE(grid);
    EXPECT_EQ(grid.errors()[0].code, ErrorCode::OutOfRange);
    EXPECT_NE(grid.errors()[0].message.find("96 MiB"), std::string::npos);
  }
}

std::string without_its_bytes(std::string file) {
  const std::size_t end = file.find("</AppendedData>");
  return file.replace(end - 1000, 1000, std::string(1000, 'x'));
}

TEST(Vtu, NarrowNumbersCountAsWhatTheyBecomeAndAreRefusedBeforeTheyAreUnpacked) {
  const auto all = [](std::string_view) { return true; };
  const Expected<VtuGrid> wide = read_vtp(without_its_bytes(bomb(200, 1, "Float64")), all);
  ASSERT_FALSE(wide);
  EXPECT_EQ(wide.errors()[0].code, ErrorCode::InputOutput);  // it fits, and was looked into
  const Expected<VtuGrid> narrow = read_vtp(without_its_bytes(bomb(200, 2, "UInt8")), all);
  ASSERT_FALSE(narrow);  // 16 Mi numbers of a byte, 12 Mi fit
  ASSERT_EQ(narrow.errors().size(), 1U);
  EXPECT_EQ(narrow.errors()[0].code, ErrorCode::OutOfRange);
}

TEST(Vtu, ArraysThatNobodyAsksForAreListedAndNotUnpacked) {
  const Expected<VtuGrid> grid = read_vtp(without_its_bytes(bomb(200, 13)), no_array);
  ASSERT_TRUE(grid);
  ASSERT_EQ(grid->point_data.size(), 200U);
  EXPECT_TRUE(grid->point_data[199].values.empty());
}

TEST(Vtu, LinesOfAPolyDataFile) {
  const auto file = [](const std::string& connectivity) {
    return "<VTKFile type='PolyData'><PolyData><Piece><Points><DataArray type='Float32' "
           "format='ascii'>0 0 0 1 0 0 0 1 0</DataArray></Points><Lines><DataArray "
           "Name='connectivity' format='ascii'>" +
           connectivity +
           "</DataArray><DataArray Name='offsets' format='ascii'>4</DataArray></Lines></Piece>"
           "</PolyData></VTKFile>";
  };
  const Expected<VtpLines> lines = read_vtp_lines(file("1 2 0 1"));
  ASSERT_TRUE(lines) << lines.errors()[0].message;
  EXPECT_EQ(lines->points_mm.rows(), 3);
  EXPECT_EQ(lines->pieces, (std::vector<std::array<int, 2>>{{1, 2}, {2, 0}, {0, 1}}));
  EXPECT_EQ(read_vtp_lines(file("1 2 0 3")).errors()[0].path, "/lines");
  EXPECT_EQ(read_vtp_lines(file("1 2 0")).errors()[0].path, "/lines/offsets");
  const Expected<Points> loop = read_mesh_line(file("1 2 0 1"), "vtp");
  ASSERT_TRUE(loop);
  EXPECT_EQ(loop->rows(), 3);
}

TEST(Vtu, RefusesCellsWithAVolume) {
  std::string text =
      "<VTKFile type='UnstructuredGrid'><UnstructuredGrid><Piece><Points><DataArray type='Float32' "
      "format='ascii'>0 0 0 1 0 0 0 1 0 0 0 1</DataArray></Points><Cells><DataArray "
      "Name='connectivity' format='ascii'>0 1 2 3</DataArray><DataArray Name='offsets' "
      "format='ascii'>4</DataArray><DataArray Name='types' format='ascii'>10</DataArray></Cells>"
      "</Piece></UnstructuredGrid></VTKFile>";
  const Expected<VtuGrid> grid = read_vtu_all(text);
  ASSERT_FALSE(grid);
  EXPECT_EQ(grid.errors()[0].code, ErrorCode::Unsupported);
  EXPECT_EQ(grid.errors()[0].path, "/cells/0");
}

}  // namespace
}  // namespace coapt
