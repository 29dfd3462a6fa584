#include "lab/leak/voxel_band.h"

#include <gtest/gtest.h>

namespace coapt {
namespace {

TEST(VoxelBand, HasItsCellsInRunsAndFindsThem) {
  LatticeValues<CellState> states({4, 2, 1}, CellState::Outside);
  states.at({0, 0, 0}) = states.at({3, 0, 0}) = CellState::Free;
  states.at({1, 1, 0}) = CellState::Fixed;
  states.at({2, 1, 0}) = CellState::Free;
  const VoxelBand band = make_band({Vec3::Zero(), 1.0, {4, 2, 1}}, states, 1);
  EXPECT_EQ(band.cells, 4);
  EXPECT_EQ(band.runs.size(), 3U);
  EXPECT_EQ(band.find({0, 0, 0}), 1);
  EXPECT_EQ(band.find({3, 0, 0}), 2);
  EXPECT_EQ(band.find({1, 1, 0}), 3);
  for (const Cell& none : {Cell{1, 0, 0}, Cell{-1, 0, 0}, Cell{0, 2, 0}, Cell{0, 0, 1}})
    EXPECT_EQ(band.find(none), 0);
  EXPECT_TRUE(band.is_fixed[3]);
  EXPECT_FALSE(band.is_fixed[4]);
}

TEST(VoxelBand, SplitCellsLieWhereTheWholeOnesDo) {
  LatticeValues<CellState> states({2, 1, 1}, CellState::Outside);
  states.at({1, 0, 0}) = CellState::Fixed;
  const VoxelLattice lattice{Vec3(5.0, 0.0, 0.0), 1.0, {2, 1, 1}};
  const VoxelBand band = make_band(lattice, states, 2);
  ASSERT_EQ(band.cells, 8);
  Vec3 sum_mm = Vec3::Zero();
  for_each_cell(band, [&](const Cell& cell, int index) {
    EXPECT_EQ(band.find(cell), index);
    EXPECT_TRUE(band.is_fixed[static_cast<std::size_t>(index)]);
    sum_mm += band.lattice.centre_mm(cell);
  });
  EXPECT_TRUE((sum_mm / 8.0).isApprox(lattice.centre_mm({1, 0, 0})));
}

TEST(Dilated, ReachesSoManyCellsAlongEachAxis) {
  LatticeValues<char> set({9, 7, 5}, 0);
  set.at({2, 3, 4}) = 1;
  const LatticeValues<char> wide = dilated(set, 2);
  for (int k = 0; k < 5; ++k)
    for (int j = 0; j < 7; ++j)
      for (int i = 0; i < 9; ++i)
        EXPECT_EQ(wide.at({i, j, k}),
                  std::abs(i - 2) <= 2 && std::abs(j - 3) <= 2 && std::abs(k - 4) <= 2);
}

}  // namespace
}  // namespace coapt
