// One surface as VTK 9.1 writes it in all of its formats (tests/readers/write_vtk_files.py).
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "io/mesh/mesh_file.h"
#include "io/mesh/vtk.h"
#include "io/mesh/vtu.h"

namespace coapt {
namespace {

namespace fs = std::filesystem;

const fs::path kFolder = fs::path(COAPT_SOURCE_DIR) / "tests/io/mesh/vtk_files";

std::string bytes_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::vector<fs::path> files(const std::string& extension) {
  std::vector<fs::path> found;
  for (const auto& entry : fs::directory_iterator(kFolder))
    if (entry.path().extension() == extension) found.push_back(entry.path());
  return found;
}

void expect_surface(const Expected<TriangleMesh>& mesh, const fs::path& path) {
  ASSERT_TRUE(mesh) << path << mesh.errors().front().path << mesh.errors().front().message;
  Points points(5, 3);
  points << 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 2, 0.5, 0.25;
  Faces faces(3, 3);
  faces << 0, 1, 2, 0, 2, 3, 1, 4, 2;
  EXPECT_EQ(mesh->vertices_mm, points) << path;
  EXPECT_EQ(mesh->faces, faces) << path;
}

TEST(VtkFiles, LegacyFilesOfBothVersionsAsTextAndBinary) {
  const std::vector<fs::path> found = files(".vtk");
  ASSERT_EQ(found.size(), 4U);
  for (const fs::path& path : found) {
    const std::string bytes = bytes_of(path);
    expect_surface(read_mesh(bytes, "vtk"), path);
    const Expected<VtkPolyData> data = read_vtk(bytes);
    ASSERT_TRUE(data) << path;
    ASSERT_EQ(data->face_data.size(), 1U) << path;
    EXPECT_EQ(data->face_data[0].name, "leaflet");
    EXPECT_EQ(data->face_data[0].values, (std::vector<double>{7, 7, 8})) << path;
  }
}

TEST(VtkFiles, SurfacesInXmlHoweverTheyArePacked) {
  const std::vector<fs::path> found = files(".vtp");
  ASSERT_EQ(found.size(), 5U);
  for (const fs::path& path : found) {
    const std::string bytes = bytes_of(path);
    expect_surface(read_mesh(bytes, "vtp"), path);
    const Expected<VtuGrid> grid = read_vtp(bytes, [](std::string_view) { return true; });
    ASSERT_TRUE(grid) << path;
    EXPECT_EQ(grid->mesh.polygons, (std::vector<int>{1, 1, 2}));
    ASSERT_EQ(grid->cell_data.size(), 1U);
    EXPECT_EQ(grid->cell_data[0].values, (std::vector<double>{0, 7, 8})) << path;
    EXPECT_EQ(read_vtu(bytes, no_array).errors().front().code, ErrorCode::Unsupported);
  }
}

TEST(VtkFiles, BinaryOnesCutShortAnywhereAreRefusedOrWhole) {
  for (const fs::path& path : files(".vtk")) {
    const std::string bytes = bytes_of(path);
    for (std::size_t length = 0; length < bytes.size(); ++length) {
      const Expected<TriangleMesh> mesh =
          read_mesh(std::string_view(bytes).substr(0, length), "vtk");
      EXPECT_TRUE(!mesh || mesh->faces.maxCoeff() <= 4) << path << length;
    }
  }
}

}  // namespace
}  // namespace coapt
