#include "lab/leak/voxel_band.h"

#include <algorithm>

namespace coapt {
namespace {

/// One line of `count` values, `stride` apart.
void dilate_line(char* line, int count, std::ptrdiff_t stride, int radius) {
  const std::size_t cells = static_cast<std::size_t>(count);
  std::vector<char> wide(cells, 0);
  int left = 0;  // cells that the last one set still reaches
  for (int i = 0; i < count; ++i) {
    left = line[i * stride] ? radius + 1 : left;
    if (left-- > 0) wide[static_cast<std::size_t>(i)] = 1;
  }
  left = 0;
  for (int i = count - 1; i >= 0; --i) {
    left = line[i * stride] ? radius + 1 : left;
    if (left-- > 0) wide[static_cast<std::size_t>(i)] = 1;
  }
  for (int i = 0; i < count; ++i) line[i * stride] = wide[static_cast<std::size_t>(i)];
}

}  // namespace

LatticeValues<char> dilated(LatticeValues<char> set, int radius) {
  const Cell strides = {1, set.size[0], set.size[0] * set.size[1]};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t one = (axis + 1) % 3, other = (axis + 2) % 3;
    for (int a = 0; a < set.size[one]; ++a)
      for (int b = 0; b < set.size[other]; ++b) {
        Cell start = {0, 0, 0};
        start[one] = a;
        start[other] = b;
        dilate_line(&set.at(start), set.size[axis], strides[axis], radius);
      }
  }
  return set;
}

std::pair<const VoxelRun*, const VoxelRun*> VoxelBand::row(int j, int k) const {
  if (j < 0 || k < 0 || j >= lattice.size[1] || k >= lattice.size[2]) return {nullptr, nullptr};
  const std::size_t at = static_cast<std::size_t>(k) * lattice.size[1] + j;
  return {runs.data() + row_runs[at], runs.data() + row_runs[at + 1]};
}

int VoxelBand::find(const Cell& cell) const {
  const auto [begin, end] = row(cell[1], cell[2]);
  for (const VoxelRun* run = begin; run != end; ++run)
    if (cell[0] >= run->begin && cell[0] < run->end) return run->first + cell[0] - run->begin;
  return 0;
}

VoxelBand make_band(const VoxelLattice& lattice, const LatticeValues<CellState>& states,
                    int split) {
  VoxelBand band;
  band.lattice = {lattice.low_mm,
                  lattice.voxel_mm / split,
                  {split * lattice.size[0], split * lattice.size[1], split * lattice.size[2]}};
  band.is_fixed.push_back(1);
  for (int k = 0; k < band.lattice.size[2]; ++k)
    for (int j = 0; j < band.lattice.size[1]; ++j) {
      band.row_runs.push_back(static_cast<int>(band.runs.size()));
      const CellState* row = &states.at({0, j / split, k / split});
      const CellState* const row_end = row + lattice.size[0];
      const auto is_outside = [](CellState state) { return state == CellState::Outside; };
      for (const CellState* at = row; at != row_end;) {
        const CellState* const from = std::find_if_not(at, row_end, is_outside);
        at = std::find_if(from, row_end, is_outside);
        if (from == at) break;
        band.runs.push_back({j, k, split * static_cast<int>(from - row),
                             split * static_cast<int>(at - row), band.cells + 1});
        for (const CellState* state = from; state != at; ++state)
          band.is_fixed.insert(band.is_fixed.end(), static_cast<std::size_t>(split),
                               *state == CellState::Fixed);
        band.cells += split * static_cast<int>(at - from);
      }
    }
  band.row_runs.push_back(static_cast<int>(band.runs.size()));
  return band;
}

}  // namespace coapt
