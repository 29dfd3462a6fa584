#include "io/mesh/imaged_state.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "io/mesh/import_sheets.h"

namespace coapt {
namespace {

constexpr int kSectors = 96;

Points circle(double radius_mm) {
  Points points(kSectors, 3);
  for (int i = 0; i < kSectors; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / kSectors;
    points.row(i) << radius_mm * std::cos(angle), radius_mm * std::sin(angle), 0.0;
  }
  return points;
}

/// Flat, from one radius to another.
TriangleMesh disc_with_hole(double hole_mm, double radius_mm) {
  TriangleMesh mesh{Points(2 * kSectors, 3), Faces(2 * kSectors, 3)};
  mesh.vertices_mm << circle(hole_mm), circle(radius_mm);
  for (int i = 0; i < kSectors; ++i) {
    const int next = (i + 1) % kSectors;
    mesh.faces.row(2 * i) << i, kSectors + i, kSectors + next;
    mesh.faces.row(2 * i + 1) << i, kSectors + next, next;
  }
  return mesh;
}

TEST(ImagedState, ADiscWithAHoleLeavesTheHolesAreaUncovered) {
  const StateSigns signs = imaged_state({disc_with_hole(6.0, 20.0)}, circle(20.0), 0.0);
  EXPECT_NEAR(signs.uncovered_share, 0.09, 0.002);
  EXPECT_EQ(signs.state, ImagedState::Closed);
}

TEST(ImagedState, HalfTheThicknessIsTakenOffTheHole) {
  const StateSigns signs = imaged_state({disc_with_hole(11.0, 20.0)}, circle(20.0), 2.0);
  EXPECT_NEAR(signs.uncovered_share, 0.25, 0.003);
}

TEST(ImagedState, AnAnnulusFarSmallerThanTheTissueIsThickIsJudgedAtOnce) {
  const StateSigns signs = imaged_state({disc_with_hole(6.0, 20.0)}, circle(1e-4), 8.0);
  EXPECT_EQ(signs.uncovered_share, 1.0);
}

TEST(ImportSheets, CoordinatesThatNoValveHasAreRefused) {
  ImportSource source;
  source.leaflets = {disc_with_hole(6.0, 20.0), disc_with_hole(6.0, 20.0)};
  source.leaflets[1].vertices_mm(3, 2) = 1e7;
  source.annulus_mm = circle(20.0);
  const Expected<ImportedValve> imported =
      import_with_decisions(source, {.chordae_seed = 1, .units = LengthUnit::Millimetre});
  ASSERT_FALSE(imported);
  EXPECT_EQ(imported.errors()[0].path, "/leaflets/1/vertices_mm");
  EXPECT_EQ(imported.errors()[0].message, "must be numbers from -1e6 to 1e6 mm");
}

}  // namespace
}  // namespace coapt
