#include "io/mesh/mid_surface.h"

#include <gtest/gtest.h>

#include <cmath>

#include "cone_scene.h"
#include "core/metrics/surface_tree.h"
#include "io/mesh/sheet_repair.h"
#include "shell_scene.h"

namespace coapt {
namespace {

struct Found {
  double rms_mm = 0.0, thickness_mm = 0.0, area_mm2 = 0.0, edge_mm = 0.0;
};

/// Against a sheet of a half cone: distance of the vertices, and of the sheet's own edge from the found sheet.
Found against(const TriangleMesh& sheet, const TriangleMesh& shell) {
  const Expected<RepairedSheet> repaired = repaired_sheet(shell, 1);
  EXPECT_TRUE(repaired) << (repaired ? "" : repaired.errors()[0].message);
  if (!repaired) return {};
  const Expected<MidSurface> middle = mid_surface(repaired->mesh);
  EXPECT_TRUE(middle) << (middle ? "" : middle.errors()[0].message);
  if (!middle) return {};
  Found found;
  const SurfaceTree made(middle->sheet.vertices_mm, middle->sheet.faces),
      known(sheet.vertices_mm, sheet.faces);
  for (const auto& v : middle->sheet.vertices_mm.rowwise()) {
    const double off = known.nearest(v.transpose()).distance_mm;
    found.rms_mm += off * off;
  }
  found.rms_mm = std::sqrt(found.rms_mm / static_cast<double>(middle->sheet.vertices_mm.rows()));
  for (const double t : middle->thickness_mm)
    found.thickness_mm += t / static_cast<double>(middle->thickness_mm.size());
  found.area_mm2 = area_mm2(middle->sheet);
  const std::vector<int> edge = boundary_loops(sheet)[0];
  for (const int v : edge)
    found.edge_mm += made.nearest(sheet.vertices_mm.row(v).transpose()).distance_mm /
                     static_cast<double>(edge.size());
  EXPECT_EQ(boundary_loops(middle->sheet).size(), 1u);
  return found;
}

TEST(MidSurface, OfAThickenedSheetIsTheSheet) {
  const TriangleMesh sheet = cone(10, 170);
  for (const double thickness : {1.0, 2.0, 3.0}) {
    const Found found = against(sheet, thickened(sheet, thickness));
    EXPECT_LT(found.rms_mm, 0.1);
    EXPECT_NEAR(found.thickness_mm, thickness, 0.1 * thickness);
    EXPECT_NEAR(found.area_mm2, area_mm2(sheet), 0.045 * thickness * area_mm2(sheet));
    EXPECT_LT(found.edge_mm, thickness / 3.0);  // the rim is square
  }
}

TEST(MidSurface, NoiseOfAThirdOfAMillimetreIsBorne) {
  const TriangleMesh sheet = cone(10, 170);
  for (const double noise : {0.1, 0.3}) {
    const Found found = against(sheet, thickened(sheet, 2.0, noise));
    EXPECT_LT(found.rms_mm, 0.2);
    EXPECT_NEAR(found.thickness_mm, 2.0, 0.2);
    EXPECT_NEAR(found.area_mm2, area_mm2(sheet), 0.12 * area_mm2(sheet));  // rough, rim square
    EXPECT_LT(found.edge_mm, 0.6);
  }
}

TEST(MidSurface, TheStaircaseOfVoxelsIsBorne) {
  const TriangleMesh sheet = cone(10, 170);
  for (const double voxel : {0.4, 0.5}) {
    const Found found = against(sheet, voxel_shell(sheet, 2.0, voxel));
    EXPECT_LT(found.rms_mm, 0.2);
    EXPECT_NEAR(found.thickness_mm, 2.0, 0.2);
    EXPECT_NEAR(found.area_mm2, area_mm2(sheet), 0.05 * area_mm2(sheet));
    EXPECT_LT(found.edge_mm, 0.5);
  }
}

TEST(MidSurface, ASheetHasNoOppositeSide) { EXPECT_LT(opposed_share(cone(10, 170)), 0.1); }

TEST(MidSurface, OfABallCannotBeTold) {
  TriangleMesh tetrahedron{30.0 * Points::Identity(4, 3), Faces(4, 3)};
  tetrahedron.faces << 0, 1, 2, 0, 3, 1, 1, 3, 2, 2, 3, 0;
  EXPECT_EQ(mid_surface(tetrahedron).errors()[0].code, ErrorCode::BadTopology);
}

}  // namespace
}  // namespace coapt
