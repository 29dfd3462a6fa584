#include "lab/leak/reference_leak.h"

#include <algorithm>
#include <cmath>

#include "lab/leak/cut_surface.h"

namespace coapt {
namespace {

constexpr double kCoarsest_mm = 1.0;
constexpr double kLeastCut = 0.02;          // of a voxel's face: less is no part of the cut
constexpr double kLeastOpening_mm2 = 0.05;  // less is a speck
constexpr double kJoined_mm = 0.5;          // cells no farther apart belong to one opening
constexpr float kDecided = 0.05F;           // sides nearer to 0 or 1 are taken for it
/// Of a cut beside the band's end: more, and the band is widened, at most so often to twice as much.
constexpr double kTouching_mm2 = 0.05, kTouchingShare = 0.005;
constexpr int kMostWidened = 2;
constexpr CutStop kOnTheWay{.iterations = 1500}, kAtLast{.iterations = 4000};

struct Level {
  VoxelBand band;
  AxisFields shares;
  MinimalCut cut;
  ReferenceLevel summary;
};

/// Around the surface with room for a cut that bulges out of it; bottom and top layers are fixed.
VoxelLattice lattice_around(const LeakSurface& surface) {
  constexpr double kBeside_mm = 3.0, kBelow_mm = 3.0, kAbove_mm = 4.0;
  VoxelLattice lattice;
  const Vec3 low_mm = surface.points_mm.colwise().minCoeff();
  const Vec3 high_mm = surface.points_mm.colwise().maxCoeff();
  lattice.voxel_mm = kCoarsest_mm;
  lattice.low_mm = low_mm - Vec3(kBeside_mm, kBeside_mm, kBelow_mm);
  const Vec3 size_mm = high_mm + Vec3(kBeside_mm, kBeside_mm, kAbove_mm) - lattice.low_mm;
  for (int axis = 0; axis < 3; ++axis)
    lattice.size[static_cast<std::size_t>(axis)] =
        static_cast<int>(std::ceil(size_mm[axis] / kCoarsest_mm));
  return lattice;
}

Level solved(VoxelBand band, const LeakSurface& surface, CutState start, bool is_last) {
  Level level;
  level.band = std::move(band);
  level.shares = free_shares(level.band, surface);
  level.cut =
      minimal_cut(level.band, level.shares, std::move(start), is_last ? kAtLast : kOnTheWay);
  level.summary = {level.band.lattice.voxel_mm, level.band.cells, level.cut.iterations,
                   level.cut.primal_mm2, level.cut.dual_mm2};
  return level;
}

Level first_level(const VoxelLattice& lattice, const LeakSurface& surface, bool is_last) {
  LatticeValues<CellState> states(lattice.size, CellState::Free);
  for (const int k : {0, lattice.size[2] - 1})
    for (int j = 0; j < lattice.size[1]; ++j)
      for (int i = 0; i < lattice.size[0]; ++i) states.at({i, j, k}) = CellState::Fixed;
  VoxelBand band = make_band(lattice, states, 1);
  CutState start;
  start.side.assign(static_cast<std::size_t>(band.cells) + 1, 0.5F);
  for_each_cell(band, [&](const Cell& cell, int index) {
    if (band.is_fixed[static_cast<std::size_t>(index)])
      start.side[static_cast<std::size_t>(index)] = cell[2] == 0 ? 0.0F : 1.0F;
  });
  return solved(std::move(band), surface, std::move(start), is_last);
}

/// Cells that the cut passes, or that lie in the blood and of which it is not decided on which side they are.
LatticeValues<char> cut_cells(const Level& level) {
  LatticeValues<char> cells(level.band.lattice.size, 0);
  const std::vector<Eigen::Vector3f> density =
      cut_density(level.band, level.shares, level.cut.state.side);
  for_each_cell(level.band, [&](const Cell& cell, int index) {
    const auto at = static_cast<std::size_t>(index);
    const float side = level.cut.state.side[at];
    const bool in_blood = std::any_of(level.shares.begin(), level.shares.end(),
                                      [&](const auto& shares) { return shares[at] == 1.0F; });
    cells.at(cell) =
        density[at].norm() > kLeastCut || (in_blood && side > kDecided && side < 1.0F - kDecided);
  });
  return cells;
}

/// By index: cells whose side is decided and that blood of the same side joins to fixed cells.
std::vector<char> cells_joined_to_a_side(const Level& level) {
  const std::vector<float>& side = level.cut.state.side;
  std::vector<char> joined(static_cast<std::size_t>(level.band.cells) + 1, 0);
  std::vector<Cell> open;
  for_each_cell(level.band, [&](const Cell& cell, int index) {
    const auto at = static_cast<std::size_t>(index);
    if (!level.band.is_fixed[at]) return;
    joined[at] = 1;
    open.push_back(cell);
  });
  while (!open.empty()) {
    const Cell cell = open.back();
    open.pop_back();
    const auto at = static_cast<std::size_t>(level.band.find(cell));
    for (std::size_t n = 0; n < 6; ++n) {
      Cell other = cell;
      other[n / 2] += n % 2 ? 1 : -1;
      const auto to = static_cast<std::size_t>(level.band.find(other));
      const bool is_open = to > 0 && level.shares[n / 2][n % 2 ? at : to] > 0.0F;
      if (!is_open || joined[to]) continue;
      if (std::abs(side[to] - std::round(side[at])) >= kDecided) continue;
      joined[to] = 1;
      open.push_back(other);
    }
  }
  return joined;
}

/// What a finer band is made from, on the coarser lattice.
struct BandAround {
  LatticeValues<CellState> states;
  LatticeValues<char> at_end;  ///< beside the layer around it
};

/// Free within band_mm of the cut. In a layer around that cells are fixed that blood joins to atrium or ventricle. Those of sealed
/// crevices are left out: their side means nothing, and fixed they would conduct.
BandAround band_around_cut(const Level& level, double band_mm) {
  const int radius = static_cast<int>(std::ceil(band_mm / level.band.lattice.voxel_mm));
  const LatticeValues<char> free = dilated(cut_cells(level), radius), edge = dilated(free, 1);
  const std::vector<char> joined = cells_joined_to_a_side(level);
  LatticeValues<CellState> states(level.band.lattice.size, CellState::Outside);
  LatticeValues<char> end(level.band.lattice.size, 0);
  for_each_cell(level.band, [&](const Cell& cell, int index) {
    const auto at = static_cast<std::size_t>(index);
    const bool was_fixed = level.band.is_fixed[at];
    if (free.at(cell) && !was_fixed)
      states.at(cell) = CellState::Free;
    else if (edge.at(cell) && joined[at])
      states.at(cell) = CellState::Fixed;
    end.at(cell) = edge.at(cell) && !free.at(cell) && !was_fixed;
  });
  return {std::move(states), dilated(std::move(end), 1)};
}

/// A finer level, and how much of its cut lies beside the end of its band.
struct FinerLevel {
  Level level;
  double touching_mm2 = 0.0;
};

FinerLevel in_band(const Level& coarse, const LeakSurface& surface, double band_mm, bool is_last) {
  const BandAround around = band_around_cut(coarse, band_mm);
  VoxelBand band = make_band(coarse.band.lattice, around.states, 2);
  CutState start;
  const std::size_t size = static_cast<std::size_t>(band.cells) + 1;
  start.side.assign(size, 0.0F);
  start.flow.fill(start.side);
  const auto parent = [](const Cell& cell) { return Cell{cell[0] / 2, cell[1] / 2, cell[2] / 2}; };
  for_each_cell(band, [&](const Cell& cell, int index) {
    const auto at = static_cast<std::size_t>(index);
    const auto from = static_cast<std::size_t>(coarse.band.find(parent(cell)));
    const float side = coarse.cut.state.side[from];
    start.side[at] = band.is_fixed[at] ? std::round(side) : side;
    for (std::size_t axis = 0; axis < 3; ++axis)
      start.flow[axis][at] = coarse.cut.state.flow[axis][from];
  });
  FinerLevel finer{solved(std::move(band), surface, std::move(start), is_last)};
  const std::vector<Eigen::Vector3f> density =
      cut_density(finer.level.band, finer.level.shares, finer.level.cut.state.side);
  const double voxel_mm2 = std::pow(finer.level.band.lattice.voxel_mm, 2.0);
  for_each_cell(finer.level.band, [&](const Cell& cell, int index) {
    if (around.at_end.at(parent(cell)))
      finer.touching_mm2 +=
          voxel_mm2 * static_cast<double>(density[static_cast<std::size_t>(index)].norm());
  });
  return finer;
}

Level finer_level(const Level& coarse, const LeakSurface& surface, double band_mm, bool is_last) {
  for (int widened = 0;; ++widened, band_mm *= 2.0) {
    FinerLevel finer = in_band(coarse, surface, band_mm, is_last);
    finer.level.summary.widened = widened;
    const double most_mm2 = std::max(kTouching_mm2, kTouchingShare * finer.level.cut.primal_mm2);
    if (finer.touching_mm2 <= most_mm2 || widened == kMostWidened) return std::move(finer.level);
  }
}

/// All cells that the cut passes and that can be reached from `start`, which are taken off `left`.
std::vector<int> take_connected(const VoxelBand& band, const Cell& start, std::vector<char>& left) {
  const int reach = static_cast<int>(std::lround(kJoined_mm / band.lattice.voxel_mm));
  std::vector<Cell> open = {start};
  std::vector<int> taken;
  const auto take = [&](const Cell& cell) {
    const int index = band.find(cell);
    if (!left[static_cast<std::size_t>(index)]) return;
    left[static_cast<std::size_t>(index)] = 0;
    taken.push_back(index);
    open.push_back(cell);
  };
  while (!open.empty()) {
    const Cell at = open.back();
    open.pop_back();
    for (int k = at[2] - reach; k <= at[2] + reach; ++k)
      for (int j = at[1] - reach; j <= at[1] + reach; ++j)
        for (int i = at[0] - reach; i <= at[0] + reach; ++i) take({i, j, k});
  }
  return taken;
}

/// @param area_mm2 to which they are scaled, if they have any
std::vector<ReferenceOpening> openings_of(const Level& level, double area_mm2) {
  const std::vector<Eigen::Vector3f> density =
      cut_density(level.band, level.shares, level.cut.state.side);
  std::vector<char> left(density.size(), 0);
  std::vector<Vec3> centres_mm(density.size());
  double cut = 0.0;
  for_each_cell(level.band, [&](const Cell& cell, int index) {
    const auto at = static_cast<std::size_t>(index);
    centres_mm[at] = level.band.lattice.centre_mm(cell);
    if (density[at].norm() <= kLeastCut) return;
    left[at] = 1;
    cut += static_cast<double>(density[at].norm());
  });
  std::vector<ReferenceOpening> openings;
  for_each_cell(level.band, [&](const Cell& cell, int index) {
    if (!left[static_cast<std::size_t>(index)]) return;
    double sum = 0.0;
    Vec3 moment = Vec3::Zero(), direction = Vec3::Zero();
    for (const int one : take_connected(level.band, cell, left)) {
      const Vec3 part = density[static_cast<std::size_t>(one)].cast<double>();
      sum += part.norm();
      moment += part.norm() * centres_mm[static_cast<std::size_t>(one)];
      direction += part;
    }
    const ReferenceOpening opening{area_mm2 * sum / cut, moment / sum, direction.normalized()};
    if (opening.area_mm2 >= kLeastOpening_mm2) openings.push_back(opening);
  });
  std::stable_sort(openings.begin(), openings.end(),
                   [](const auto& a, const auto& b) { return a.area_mm2 > b.area_mm2; });
  return openings;
}

}  // namespace

ReferenceLeak reference_leak(const LeakSurface& surface, const ReferenceOptions& options) {
  const double reach_mm =
      (surface.points_mm.colwise().maxCoeff() - surface.points_mm.colwise().minCoeff()).norm();
  const LeakSurface closed_off = with_skirt(surface, reach_mm);
  const auto is_last = [&](double voxel_mm) { return voxel_mm < 1.5 * options.finest_mm; };
  ReferenceLeak leak;
  Level level = first_level(lattice_around(surface), closed_off, is_last(kCoarsest_mm));
  leak.levels.push_back(level.summary);
  while (!is_last(level.band.lattice.voxel_mm)) {
    level =
        finer_level(level, closed_off, options.band_mm, is_last(0.5 * level.band.lattice.voxel_mm));
    leak.levels.push_back(level.summary);
  }
  leak.primal_mm2 = level.cut.primal_mm2;
  leak.dual_mm2 = level.cut.dual_mm2;
  leak.surface_mm2 = cut_surface_mm2(level.band, level.shares, level.cut.state.side, closed_off);
  leak.area_mm2 =
      std::min(leak.surface_mm2, std::max(0.0, 0.5 * (leak.primal_mm2 + leak.dual_mm2)));
  leak.openings = openings_of(level, leak.area_mm2);
  return leak;
}

}  // namespace coapt
