#include "io/mesh/ring_solid.h"

#include <gtest/gtest.h>

#include <map>
#include <numbers>

#include "core/repair/ring_terms.h"
#include "io/mesh/write_mesh.h"

namespace coapt {
namespace {

Points ring_line(double radius_mm) {
  Points contour(720, 3);
  for (int i = 0; i < 720; ++i) {
    const double t = 2.0 * std::numbers::pi * i / 720.0;
    contour.row(i) << radius_mm * std::cos(t), radius_mm * std::sin(t), 0.0;
  }
  return contour;
}

/// Each edge once in either direction: closed, and all faces turned the same way.
bool is_closed(const TriangleMesh& mesh) {
  std::map<std::pair<int, int>, int> edges;
  for (Index f = 0; f < mesh.faces.rows(); ++f)
    for (int k = 0; k < 3; ++k) ++edges[{mesh.faces(f, k), mesh.faces(f, (k + 1) % 3)}];
  for (const auto& [edge, count] : edges)
    if (count != 1 || !edges.contains({edge.second, edge.first})) return false;
  return true;
}

// Pappus: area of the section times the way of its centroid.
TEST(RingSolid, OfACircleHasTheVolumeOfPappus) {
  const RingSection section;
  const auto corners = section_corners_mm(section);
  double twice = 0.0, moment = 0.0;
  for (Index i = 0; i < corners.rows(); ++i) {
    const Index j = (i + 1) % corners.rows();
    const double cross = corners(i, 0) * corners(j, 1) - corners(j, 0) * corners(i, 1);
    twice += cross;
    moment += (corners(i, 0) + corners(j, 0)) * cross / 6.0;
  }
  const double area = 0.5 * twice;
  // By hand: the disc of 1.2 mm, less the cap behind the band, and the band.
  const double half_angle = std::asin(0.4 / 1.2);
  const double cap_to_band =
      1.44 * (std::numbers::pi - half_angle) + 0.4 * 1.2 * std::cos(half_angle);
  const double band = 0.8 * (2.8 - 1.2 * std::cos(half_angle));
  EXPECT_NEAR(area, cap_to_band + band, 0.02 * area);
  const double volume = 2.0 * std::numbers::pi * (15.0 * area + moment);
  EXPECT_NEAR(enclosed_mm3(ring_solid(ring_line(15.0), section)), volume, 1e-3 * volume);
}

TEST(RingSolid, IsClosedWithItsNormalsOutwards) {
  const Points contour = ring_contour_mm({0.7, 0.01, 0.05, 0.15, 0.05, -0.05}, 30.0);
  const TriangleMesh mesh = ring_solid(contour);
  EXPECT_TRUE(is_closed(mesh));
  EXPECT_GT(enclosed_mm3(mesh), 0.0);
  const Expected<std::string> stl = write_mesh(mesh, "stl");
  ASSERT_TRUE(stl);
  const Expected<TriangleMesh> read = read_mesh(*stl, "stl");
  ASSERT_TRUE(read);
  EXPECT_TRUE(is_closed(*read)) << "as a printer's program reads it";
  EXPECT_EQ(read->vertices_mm.rows(), mesh.vertices_mm.rows());
}

}  // namespace
}  // namespace coapt
