#include "lab/leak/free_shares.h"

#include <gtest/gtest.h>

namespace coapt {
namespace {

/// A large triangle in the plane z = `height_mm`.
LeakSurface sheet(double height_mm, double half_thickness_mm) {
  LeakSurface surface;
  surface.half_thickness_mm = half_thickness_mm;
  surface.points_mm.resize(3, 3);
  surface.points_mm << -50.0, -50.0, height_mm, 50.0, -50.0, height_mm, 0.0, 80.0, height_mm;
  surface.faces.resize(1, 3);
  surface.faces << 0, 1, 2;
  return surface;
}

VoxelBand column_of_voxels() {
  const VoxelLattice lattice{Vec3::Zero(), 1.0, {2, 2, 6}};
  return make_band(lattice, LatticeValues<CellState>(lattice.size, CellState::Free), 1);
}

TEST(FreeShares, ASheetShutsTheFacesWithinIt) {
  const VoxelBand band = column_of_voxels();
  const AxisFields shares = free_shares(band, sheet(3.0, 0.5));
  for (int k = 0; k < 5; ++k)  // the face above cell k lies at k + 1
    EXPECT_EQ(shares[2][static_cast<std::size_t>(band.find({0, 0, k}))], k == 2 ? 0.0F : 1.0F) << k;
  EXPECT_EQ(shares[2][static_cast<std::size_t>(band.find({0, 0, 5}))], 0.0F);  // nothing above
}

TEST(FreeShares, AFaceThatASheetCutsIsFreeBesideIt) {
  // The faces between columns reach from 2 to 3 and from 3 to 4; the sheet takes 2.5 to 3.5: two of four rows of points each.
  const VoxelBand band = column_of_voxels();
  const AxisFields shares = free_shares(band, sheet(3.0, 0.5));
  EXPECT_EQ(shares[0][static_cast<std::size_t>(band.find({0, 0, 2}))], 0.5F);
  EXPECT_EQ(shares[1][static_cast<std::size_t>(band.find({0, 0, 3}))], 0.5F);
  EXPECT_EQ(shares[0][static_cast<std::size_t>(band.find({0, 0, 4}))], 1.0F);
  EXPECT_EQ(shares[0][static_cast<std::size_t>(band.find({1, 0, 4}))], 0.0F);  // the lattice's end
}

TEST(FreeShares, BetweenFixedCellsNothingIsCut) {
  const VoxelLattice lattice{Vec3::Zero(), 1.0, {2, 1, 1}};
  const VoxelBand band =
      make_band(lattice, LatticeValues<CellState>(lattice.size, CellState::Fixed), 1);
  EXPECT_EQ(free_shares(band, sheet(40.0, 0.5))[0][1], 0.0F);
}

}  // namespace
}  // namespace coapt
