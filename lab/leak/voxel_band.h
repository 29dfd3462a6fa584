// Part of a cubic lattice, kept as runs of cells along x: arrays over its cells have no gaps, and only cells that are asked for cost
// anything.
#pragma once

#include <array>
#include <vector>

#include "core/valve/types.h"

namespace coapt {

using Cell = std::array<int, 3>;  ///< columns along x, y, z

/// Cubes of voxel_mm; the centre of cell (i, j, k) is low_mm + (i + 1/2, j + 1/2, k + 1/2) voxel_mm.
struct VoxelLattice {
  Vec3 low_mm = Vec3::Zero();
  double voxel_mm = 1.0;
  Cell size = {0, 0, 0};

  Vec3 centre_mm(const Cell& cell) const {
    return low_mm + voxel_mm * Vec3(cell[0] + 0.5, cell[1] + 0.5, cell[2] + 0.5);
  }
};

/// A value for every cell of a lattice, x running fastest.
template <class T>
struct LatticeValues {
  LatticeValues(const Cell& cells, T value)
      : size(cells), values(static_cast<std::size_t>(cells[0]) * cells[1] * cells[2], value) {}

  T& at(const Cell& cell) { return values[place(cell)]; }
  const T& at(const Cell& cell) const { return values[place(cell)]; }

  Cell size;
  std::vector<T> values;

 private:
  std::size_t place(const Cell& cell) const {
    return (static_cast<std::size_t>(cell[2]) * size[1] + cell[1]) * size[0] + cell[0];
  }
};

/// What is within `radius` cells of a cell that is set, along each axis, is set.
LatticeValues<char> dilated(LatticeValues<char> set, int radius);

enum class CellState : char { Outside, Free, Fixed };

/// Cells [begin, end) of row (j, k); that at `begin` has index `first` in arrays over the band.
struct VoxelRun {
  int j = 0, k = 0, begin = 0, end = 0, first = 0;
};

/// Arrays over a band have its cells at 1 to `cells`; 0 is no cell.
struct VoxelBand {
  VoxelLattice lattice;
  std::vector<VoxelRun> runs;  ///< by row, from left to right
  std::vector<int> row_runs;   ///< first run of each row j + k size[1], and the number of runs
  std::vector<char> is_fixed;  ///< by index
  int cells = 0;

  /// The index of a cell; 0 if it is not in the band or the lattice.
  int find(const Cell& cell) const;
  /// Runs of row (j, k).
  std::pair<const VoxelRun*, const VoxelRun*> row(int j, int k) const;
};

/// The cells of `states` that are not Outside, each cut into split x split x split.
VoxelBand make_band(const VoxelLattice& lattice, const LatticeValues<CellState>& states, int split);

/// visit(cell, index) for every cell, by index.
template <class Visit>
void for_each_cell(const VoxelBand& band, const Visit& visit) {
  for (const VoxelRun& run : band.runs)
    for (int i = run.begin; i < run.end; ++i)
      visit(Cell{i, run.j, run.k}, run.first + i - run.begin);
}

}  // namespace coapt
