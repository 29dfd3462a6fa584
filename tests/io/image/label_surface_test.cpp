#include "io/image/label_surface.h"

#include <gtest/gtest.h>

#include <map>
#include <numbers>
#include <random>

#include "io/image/label_voxels.h"
#include "tests/io/image/drawn_labels.h"

namespace coapt {
namespace {

Eigen::Matrix4d cubic(double edge_mm) {
  Eigen::Matrix4d frame = Eigen::Matrix4d::Identity();
  frame.topLeftCorner<3, 3>() *= edge_mm;
  return frame;
}

double volume_mm3(const TriangleMesh& mesh) {
  const Vec3 origin = mesh.vertices_mm.row(0);
  double sum = 0.0;
  for (Index f = 0; f < mesh.faces.rows(); ++f) {
    const Vec3 a = Vec3(mesh.vertices_mm.row(mesh.faces(f, 0))) - origin,
               b = Vec3(mesh.vertices_mm.row(mesh.faces(f, 1))) - origin,
               c = Vec3(mesh.vertices_mm.row(mesh.faces(f, 2))) - origin;
    sum += a.dot(b.cross(c)) / 6.0;
  }
  return sum;
}

double area_mm2(const TriangleMesh& mesh) {
  double sum = 0.0;
  for (Index f = 0; f < mesh.faces.rows(); ++f) {
    const Vec3 a = mesh.vertices_mm.row(mesh.faces(f, 0)),
               b = mesh.vertices_mm.row(mesh.faces(f, 1)),
               c = mesh.vertices_mm.row(mesh.faces(f, 2));
    sum += 0.5 * (b - a).cross(c - a).norm();
  }
  return sum;
}

/// Each directed edge once, with its opposite; one fan of triangles about each vertex.
void expect_closed_manifold(const TriangleMesh& mesh) {
  std::map<std::pair<int, int>, int> next;  // of a vertex's triangles: the third corner
  std::map<int, int> triangles;
  for (Index f = 0; f < mesh.faces.rows(); ++f)
    for (int k = 0; k < 3; ++k) {
      const int a = mesh.faces(f, k), b = mesh.faces(f, (k + 1) % 3),
                c = mesh.faces(f, (k + 2) % 3);
      EXPECT_TRUE(next.emplace(std::pair(a, b), c).second) << "edge used twice";
      ++triangles[a];
    }
  for (const auto& [edge, third] : next)
    EXPECT_TRUE(next.contains({edge.second, edge.first})) << "edge without opposite";
  EXPECT_EQ(std::ssize(triangles), mesh.vertices_mm.rows()) << "loose vertices";
  std::map<int, int> first;
  for (const auto& [edge, third] : next) first.emplace(edge.first, edge.second);
  for (const auto& [vertex, start] : first) {
    int length = 0, at = start;
    do {
      at = next.at({vertex, at});
      ++length;
    } while (at != start && length <= triangles[vertex]);
    EXPECT_EQ(length, triangles[vertex]) << "more than one fan";
  }
}

/// How many pieces hang together.
int pieces(const TriangleMesh& mesh) {
  std::vector<int> parent(static_cast<std::size_t>(mesh.vertices_mm.rows()));
  for (std::size_t i = 0; i < parent.size(); ++i) parent[i] = static_cast<int>(i);
  const auto root = [&](int v) {
    while (parent[static_cast<std::size_t>(v)] != v) v = parent[static_cast<std::size_t>(v)];
    return v;
  };
  for (Index f = 0; f < mesh.faces.rows(); ++f)
    for (int k = 1; k < 3; ++k)
      parent[static_cast<std::size_t>(root(mesh.faces(f, k)))] = root(mesh.faces(f, 0));
  int count = 0;
  for (std::size_t i = 0; i < parent.size(); ++i) count += parent[i] == static_cast<int>(i) ? 1 : 0;
  return count;
}

int euler(const TriangleMesh& mesh) {
  return static_cast<int>(mesh.vertices_mm.rows() - mesh.faces.rows() / 2);
}

TEST(LabelSurface, SphereHasItsVolumeAreaAndRadius) {
  const LabelMap map = drawn_labels({30, 30, 30}, cubic(0.5), [](const Vec3& x) {
    return (x - Vec3(7.2, 7.3, 7.1)).norm() <= 5.0;
  });
  const Expected<TriangleMesh> mesh = label_surface(map, {0, 1});
  ASSERT_TRUE(mesh);
  expect_closed_manifold(*mesh);
  EXPECT_EQ(euler(*mesh), 2);
  EXPECT_NEAR(volume_mm3(*mesh), 4.0 / 3.0 * std::numbers::pi * 125.0, 0.01 * 523.6);
  EXPECT_NEAR(area_mm2(*mesh), 4.0 * std::numbers::pi * 25.0, 0.03 * 314.2);
  for (const auto& vertex : mesh->vertices_mm.rowwise())
    EXPECT_NEAR((Vec3(vertex) - Vec3(7.2, 7.3, 7.1)).norm(), 5.0, 0.25) << "half a voxel";
}

TEST(LabelSurface, OneVoxelIsASmallClosedBody) {
  const LabelMap map = drawn_labels({1, 1, 1}, cubic(2.0), [](const Vec3&) { return true; });
  const Expected<TriangleMesh> mesh = label_surface(map, {0, 1});
  ASSERT_TRUE(mesh);
  expect_closed_manifold(*mesh);
  EXPECT_GT(volume_mm3(*mesh), 0.0);
  EXPECT_LT(volume_mm3(*mesh), 8.5);
}

TEST(LabelSurface, FlatSlabKeepsItsThicknessAwayFromItsRim) {
  for (const int voxels : {1, 2, 3}) {
    const LabelMap map = drawn_labels({30, 24, 8}, cubic(1.0), [&](const Vec3& x) {
      return x.x() > 2 && x.x() < 27 && x.y() > 2 && x.y() < 21 && x.z() >= 3 && x.z() < 3 + voxels;
    });
    const Expected<TriangleMesh> mesh = label_surface(map, {0, 1});
    ASSERT_TRUE(mesh);
    expect_closed_manifold(*mesh);
    EXPECT_EQ(euler(*mesh), 2);
    EXPECT_NEAR(volume_mm3(*mesh), 24.0 * 18.0 * voxels, 0.02 * 24 * 18 * voxels);
    for (const auto& vertex : mesh->vertices_mm.rowwise()) {
      if (vertex.x() < 7 || vertex.x() > 22 || vertex.y() < 7 || vertex.y() > 16) continue;
      EXPECT_NEAR(std::abs(vertex.z() - (2.5 + 0.5 * voxels)), 0.5 * voxels, 0.1);
    }
  }
}

TEST(LabelSurface, LongVoxelsInAnObliqueFrameOfEitherHandLieWhereTheyShould) {
  for (const bool mirrored : {false, true}) {
    const std::array<Index, 3> size = {44, 44, 22};
    const LabelMap map =
        drawn_labels(size, oblique_frame(size, {0.4, 0.4, 0.9}, mirrored),
                     [](const Vec3& x) { return (x - kObliqueMiddle_mm).norm() <= 7.0; });
    const Expected<TriangleMesh> mesh = label_surface(map, {0, 1});
    ASSERT_TRUE(mesh);
    expect_closed_manifold(*mesh);
    EXPECT_NEAR(volume_mm3(*mesh), 4.0 / 3.0 * std::numbers::pi * 343.0, 0.01 * 1436.8)
        << "positive: oriented outwards";
    for (const auto& vertex : mesh->vertices_mm.rowwise())
      EXPECT_NEAR((Vec3(vertex) - kObliqueMiddle_mm).norm(), 7.0, 0.45);
  }
}

/// A cap of a spherical shell: curved, thin, and oblique to all axes somewhere.
void expect_whole_shell(double thickness, double volume_tolerance) {
  constexpr double kRadius = 15.0, kHeight = 5.0;  // of the cap's rim over the centre
  const Vec3 centre(20.3, 20.1, 3.2);
  const LabelMap map = drawn_labels({41, 41, 26}, cubic(1.0), [&](const Vec3& x) {
    const double radius = (x - centre).norm();
    return x.z() > centre.z() + kHeight && radius >= kRadius - 0.5 * thickness &&
           radius < kRadius + 0.5 * thickness;
  });
  const Expected<TriangleMesh> mesh = label_surface(map, {0, 1});
  ASSERT_TRUE(mesh);
  expect_closed_manifold(*mesh);
  EXPECT_EQ(pieces(*mesh), 1);
  EXPECT_EQ(euler(*mesh), 2) << "no holes";
  const double area = 2.0 * std::numbers::pi * kRadius * (kRadius - kHeight);
  EXPECT_NEAR(volume_mm3(*mesh), area * thickness, volume_tolerance * area * thickness);
  double least = 1e300, most = 0.0;
  for (const auto& vertex : mesh->vertices_mm.rowwise()) {
    least = std::min(least, (Vec3(vertex) - centre).norm());
    most = std::max(most, (Vec3(vertex) - centre).norm());
  }
  EXPECT_GT(least, kRadius - 0.5 * thickness - 0.5);
  EXPECT_LT(most, kRadius + 0.5 * thickness + 0.5);
}

TEST(LabelSurface, CurvedSheetOfOneVoxelStaysWhole) { expect_whole_shell(1.0, 0.06); }
TEST(LabelSurface, CurvedSheetOfTwoVoxelsStaysWhole) { expect_whole_shell(2.0, 0.06); }

TEST(LabelSurface, DiagonalSheetThatTouchesAtEdgesOnlyIsOneSmoothSheet) {
  for (const double sign : {1.0, -1.0}) {
    const LabelMap map = drawn_labels({24, 24, 16}, cubic(1.0), [&](const Vec3& x) {
      return std::abs(x.y() - 11.5 - sign * (x.x() - 11.5)) < 0.1 && x.x() > 1 && x.x() < 22 &&
             x.z() > 1 && x.z() < 14;
    });
    const Expected<TriangleMesh> mesh = label_surface(map, {0, 1});
    ASSERT_TRUE(mesh);
    expect_closed_manifold(*mesh);
    EXPECT_EQ(pieces(*mesh), 1);
    EXPECT_EQ(euler(*mesh), 2);
    for (const auto& vertex : mesh->vertices_mm.rowwise()) {
      if (vertex.x() < 7 || vertex.x() > 16 || vertex.z() < 5 || vertex.z() > 10) continue;
      const double off = std::abs(vertex.y() - 11.5 - sign * (vertex.x() - 11.5)) / std::sqrt(2.0);
      EXPECT_NEAR(off, 0.25 * std::sqrt(2.0), 0.12) << "half the mean thickness of the stairs";
    }
  }
}

TEST(LabelSurface, NoiseIsAClosedManifoldToo) {
  std::mt19937 random(3);
  for (const unsigned share : {2U, 3U, 5U, 9U}) {
    const LabelMap map =
        drawn_labels({14, 13, 12}, cubic(1.0), [&](const Vec3&) { return random() % share == 0; });
    const Expected<TriangleMesh> mesh = label_surface(map, {0, 1});
    ASSERT_TRUE(mesh);
    expect_closed_manifold(*mesh);
    EXPECT_TRUE(mesh->vertices_mm.allFinite());
    const LabelVoxels voxels(map, {0, 1});
    EXPECT_EQ(mesh->faces.rows(), 2 * voxels.crossings(voxels.box())) << "counted before";
  }
}

TEST(LabelSurface, ACheckerboardIsRefusedWithItsTriangles) {
  constexpr Index kEdge = 56;  // half of its voxels, six faces each, two triangles a face
  LabelMap map;
  map.size = {kEdge, kEdge, kEdge};
  for (Index v = 0; v < kEdge * kEdge * kEdge; ++v)
    map.voxels.push_back((v + v / kEdge + v / (kEdge * kEdge)) % 2 == 0 ? 1 : 0);
  const Expected<TriangleMesh> mesh = label_surface(map, {0, 1});
  ASSERT_FALSE(mesh);
  EXPECT_EQ(mesh.errors()[0].code, ErrorCode::OutOfRange);
  EXPECT_TRUE(mesh.errors()[0].message.starts_with(
      "has 1053696 triangles around label 1, must be at most 1000000"));
}

TEST(LabelSurface, ALabelThatIsNotThereIsSaid) {
  const LabelMap map = drawn_labels({3, 3, 3}, cubic(1.0), [](const Vec3&) { return true; });
  const Expected<TriangleMesh> mesh = label_surface(map, {0, 7});
  ASSERT_FALSE(mesh);
  EXPECT_EQ(mesh.errors()[0].code, ErrorCode::BadReference);
  EXPECT_EQ(mesh.errors()[0].message, "has no voxel of label 7");
}

}  // namespace
}  // namespace coapt
