#include "lab/leak/minimal_cut.h"

#include <gtest/gtest.h>

namespace coapt {
namespace {

constexpr Cell kBox = {6, 5, 8};

VoxelBand box() {
  LatticeValues<CellState> states(kBox, CellState::Free);
  for (const int k : {0, kBox[2] - 1})
    for (int j = 0; j < kBox[1]; ++j)
      for (int i = 0; i < kBox[0]; ++i) states.at({i, j, k}) = CellState::Fixed;
  return make_band({Vec3::Zero(), 0.5, kBox}, states, 1);
}

AxisFields open_faces(const VoxelBand& band) {
  AxisFields shares;
  shares.fill(std::vector<float>(static_cast<std::size_t>(band.cells) + 2, 0.0F));
  for_each_cell(band, [&](const Cell& cell, int index) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      Cell next = cell;
      ++next[axis];
      const int neighbour = band.find(next);
      const bool fixed = band.is_fixed[static_cast<std::size_t>(index)] &&
                         band.is_fixed[static_cast<std::size_t>(neighbour)];
      if (neighbour > 0 && !fixed) shares[axis][static_cast<std::size_t>(index)] = 1.0F;
    }
  });
  return shares;
}

MinimalCut cut_of(const VoxelBand& band, const AxisFields& shares) {
  CutState start;
  start.side.assign(static_cast<std::size_t>(band.cells) + 1, 0.5F);
  for_each_cell(band, [&](const Cell& cell, int index) {
    if (cell[2] == 0 || cell[2] == kBox[2] - 1)
      start.side[static_cast<std::size_t>(index)] = cell[2] == 0 ? 0.0F : 1.0F;
  });
  return minimal_cut(band, shares, std::move(start), {.iterations = 3000, .gap_mm2 = 1e-3});
}

TEST(MinimalCut, OfAnEmptyBoxIsItsCrossSection) {
  const VoxelBand band = box();
  const MinimalCut cut = cut_of(band, open_faces(band));
  EXPECT_NEAR(cut.primal_mm2, 3.0 * 2.5, 0.02);
  EXPECT_NEAR(cut.dual_mm2, 3.0 * 2.5, 0.02);
  EXPECT_LT(cut.iterations, 3000);
}

TEST(MinimalCut, TakesTheNarrowestLayer) {
  const VoxelBand band = box();
  AxisFields shares = open_faces(band);
  for_each_cell(band, [&](const Cell& cell, int index) {
    if (cell[2] == 4) shares[2][static_cast<std::size_t>(index)] = cell[0] < 3 ? 0.25F : 0.0F;
  });
  EXPECT_NEAR(cut_of(band, shares).primal_mm2, 0.25 * 1.5 * 2.5, 0.01);
}

TEST(MinimalCut, StopsAtItsIterations) {
  const VoxelBand band = box();
  CutState start;
  start.side.assign(static_cast<std::size_t>(band.cells) + 1, 0.5F);
  EXPECT_EQ(minimal_cut(band, open_faces(band), start,
                        {.iterations = 3, .gap_mm2 = 0.0, .gap_share = 0.0})
                .iterations,
            3);
}

}  // namespace
}  // namespace coapt
