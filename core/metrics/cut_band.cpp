#include "core/metrics/cut_band.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace coapt {
namespace {

constexpr double kBand_mm = 1.5;
constexpr int kWidenings = 4;
constexpr double kReached = 0.2;  // of a border's square

class BandBuilder {
 public:
  BandBuilder(const Partition& partition, const VoxelGrid& coarse, const AtrialSide& side)
      : partition_(partition),
        coarse_(coarse),
        is_atrial_(side.is_atrial),
        marks_(side.is_atrial.size(), 0) {
    for (const auto& [voxel, axis] : side.cut) {
      Vec3 middle = coarse.centre_mm(coarse.place(voxel));
      middle[axis] += 0.5 * coarse.side_mm;
      mark_about(middle);
    }
    for (int widening = 0; widening <= kWidenings; ++widening) {
      gather();
      surface_ = least_surface(grid_, voxels_);
      if (!widen()) break;
    }
  }

  CutBand result() && {
    return {std::move(grid_), std::move(voxels_), std::move(places_), std::move(surface_)};
  }

 private:
  static constexpr int kFinePerCoarse = 2, kFine = 8;
  static constexpr float kUnknown = 0.5f;

  /// Marks the coarse voxels whose centres lie within kBand_mm of a point; none in the grid's two outermost layers.
  void mark_about(const Vec3& point_mm) {
    const Vec3 at = (point_mm - coarse_.corner_mm) / coarse_.side_mm - Vec3::Constant(0.5);
    const double reach = kBand_mm / coarse_.side_mm;
    std::array<int, 3> first{}, last{};
    for (int axis = 0; axis < 3; ++axis) {
      const auto k = static_cast<std::size_t>(axis);
      first[k] = std::max(2, static_cast<int>(std::ceil(at[axis] - reach)));
      last[k] = std::min(coarse_.size[k] - 3, static_cast<int>(std::floor(at[axis] + reach)));
    }
    for (int z = first[2]; z <= last[2]; ++z)
      for (int y = first[1]; y <= last[1]; ++y)
        for (int x = first[0]; x <= last[0]; ++x)
          if ((Vec3(x, y, z) - at).squaredNorm() <= reach * reach)
            marks_[static_cast<std::size_t>(coarse_.number({x, y, z}))] = 1;
  }

  /// The fine voxels of the marked coarse ones, and the border around them.
  void gather() {
    const std::vector<BandVoxel> before = std::move(voxels_);
    const VoxelGrid grid_before = grid_;
    std::vector<int> marked;
    for (int voxel = 0; voxel < coarse_.count(); ++voxel)
      if (marks_[static_cast<std::size_t>(voxel)] != 0) marked.push_back(voxel);
    lay_grid(marked);
    give_slots(marked);
    free_ = free_points(partition_, grid_, slots_, static_cast<int>(fine_.size()));
    parted_ = partings(partition_, grid_);
    for (std::size_t i = 0; i < fine_.size(); ++i)
      for (std::size_t axis = 0; axis < 3; ++axis)
        if (parted_[static_cast<std::size_t>(fine_[i])][axis]) free_[i][axis] = 0;
    const std::vector<float> sides = sides_of_slots();

    voxels_.clear();
    std::vector<char> is_border(fine_.size(), 0);
    const auto add = [&](int voxel, bool is_fixed) {
      voxels_.push_back({voxel, is_fixed, sides[slot(voxel)], free_[slot(voxel)]});
    };
    const std::array<int, 6> around = around_fine();
    for (std::size_t i = 0; i < kFine * marked.size(); ++i) {
      bool is_free = false;
      for (std::size_t k = 0; k < around.size(); ++k) {
        const int neighbour = fine_[i] + around[k], lower = std::min(fine_[i], neighbour);
        const std::size_t axis = k < 3 ? 2 - k : k - 3;
        if (free_[slot(lower)][axis] == 0) continue;
        is_free = true;
        const std::size_t beside = slot(neighbour);
        if (beside < kFine * marked.size() || is_border[beside] != 0 || sides[beside] == kUnknown)
          continue;
        is_border[beside] = 1;
        add(neighbour, true);
      }
      if (is_free) add(fine_[i], false);
    }
    std::sort(voxels_.begin(), voxels_.end(),
              [](const BandVoxel& a, const BandVoxel& b) { return a.voxel < b.voxel; });
    places_.assign(slots_.size(), -1);
    for (std::size_t i = 0; i < voxels_.size(); ++i)
      places_[static_cast<std::size_t>(voxels_[i].voxel)] = static_cast<int>(i);
    for (std::size_t i = 0; i < before.size(); ++i) {
      const Vec3 centre = grid_before.centre_mm(grid_before.place(before[i].voxel));
      const int place = places_[static_cast<std::size_t>(grid_.number(grid_.place_of(centre)))];
      if (place >= 0 && !before[i].is_fixed && !voxels_[static_cast<std::size_t>(place)].is_fixed)
        voxels_[static_cast<std::size_t>(place)].u = surface_.u[i];
    }
  }

  /// Over the coarse voxels, two more about them.
  void lay_grid(const std::vector<int>& marked) {
    std::array<int, 3> first = coarse_.size, last{};
    for (const int voxel : marked) {
      const std::array<int, 3> place = coarse_.place(voxel);
      for (std::size_t k = 0; k < 3; ++k) {
        first[k] = std::min(first[k], place[k] - 2);
        last[k] = std::max(last[k], place[k] + 2);
      }
    }
    grid_.side_mm = coarse_.side_mm / kFinePerCoarse;
    for (int axis = 0; axis < 3; ++axis) {
      const auto k = static_cast<std::size_t>(axis);
      grid_.corner_mm[axis] = coarse_.corner_mm[axis] + coarse_.side_mm * first[k];
      grid_.size[k] = kFinePerCoarse * std::max(0, last[k] - first[k] + 1);
    }
    origin_ = first;
  }

  /// Numbers the fine voxels: those of marked coarse ones, then those of their neighbours, eight by eight.
  void give_slots(const std::vector<int>& marked) {
    slots_.assign(static_cast<std::size_t>(grid_.count()), -1);
    fine_.clear();
    coarse_of_eight_.clear();
    const auto give = [&](int coarse) {
      const std::array<int, 3> place = coarse_.place(coarse);
      const int first = grid_.number({kFinePerCoarse * (place[0] - origin_[0]),
                                      kFinePerCoarse * (place[1] - origin_[1]),
                                      kFinePerCoarse * (place[2] - origin_[2])});
      if (slots_[static_cast<std::size_t>(first)] >= 0) return;
      coarse_of_eight_.push_back(coarse);
      for (int k = 0; k < kFine; ++k) {
        const int voxel =
            first + (k & 1) + (k >> 1 & 1) * grid_.stride(1) + (k >> 2) * grid_.stride(2);
        slots_[static_cast<std::size_t>(voxel)] = static_cast<int>(fine_.size());
        fine_.push_back(voxel);
      }
    };
    for (const int coarse : marked) give(coarse);
    for (const int coarse : marked)
      for (int axis = 0; axis < 3; ++axis) {
        give(coarse - coarse_.stride(axis));
        give(coarse + coarse_.stride(axis));
      }
  }

  /// By slot: 1 on the atrial side, 0 on the other one, kUnknown where tissue parts a voxel from all that are known. The centre of a
  /// coarse voxel is the corner that its fine ones share.
  std::vector<float> sides_of_slots() const {
    std::vector<float> sides(fine_.size(), kUnknown);
    std::vector<int> known;
    for (std::size_t eight = 0; eight < coarse_of_eight_.size(); ++eight) {
      bool is_parted = false;
      for (std::size_t k = 0; k < kFine; ++k) {
        const auto& parted = parted_[static_cast<std::size_t>(fine_[kFine * eight + k])];
        for (std::size_t axis = 0; axis < 3; ++axis)
          is_parted = is_parted || ((k >> axis & 1) == 0 && parted[axis]);
      }
      if (is_parted) continue;
      for (std::size_t i = kFine * eight; i < kFine * (eight + 1); ++i) {
        sides[i] = is_atrial_[static_cast<std::size_t>(coarse_of_eight_[eight])] != 0 ? 1.0f : 0.0f;
        known.push_back(static_cast<int>(i));
      }
    }
    const std::array<int, 6> around = around_fine();
    for (std::size_t i = 0; i < known.size(); ++i) {
      const auto from = static_cast<std::size_t>(known[i]);
      for (std::size_t k = 0; k < around.size(); ++k) {
        const int neighbour = fine_[from] + around[k], lower = std::min(fine_[from], neighbour);
        const int to = slots_[static_cast<std::size_t>(neighbour)];
        if (to < 0 || sides[static_cast<std::size_t>(to)] != kUnknown ||
            parted_[static_cast<std::size_t>(lower)][k < 3 ? 2 - k : k - 3])
          continue;
        sides[static_cast<std::size_t>(to)] = sides[from];
        known.push_back(to);
      }
    }
    return sides;
  }

  /// Marks voxels about those of the border that the cut has reached. @return whether there are any
  bool widen() {
    bool is_reached = false;
    for (std::size_t i = 0; i < voxels_.size(); ++i)
      for (int axis = 0; axis < 3; ++axis) {
        const int next = places_[static_cast<std::size_t>(voxels_[i].voxel + grid_.stride(axis))];
        if (next < 0) continue;
        const BandVoxel& other = voxels_[static_cast<std::size_t>(next)];
        if (voxels_[i].is_fixed == other.is_fixed) continue;
        const double share =
            static_cast<double>(voxels_[i].free[static_cast<std::size_t>(axis)]) / kPointsOfSquare;
        const float change = surface_.u[i] - surface_.u[static_cast<std::size_t>(next)];
        if (share * std::abs(static_cast<double>(change)) <= kReached) continue;
        is_reached = true;
        mark_about(
            grid_.centre_mm(grid_.place(voxels_[i].is_fixed ? voxels_[i].voxel : other.voxel)));
      }
    return is_reached;
  }

  std::size_t slot(int voxel) const {
    return static_cast<std::size_t>(slots_[static_cast<std::size_t>(voxel)]);
  }

  /// From a fine voxel's number to those of its neighbours: back along z, y and x, on along x, y and z.
  std::array<int, 6> around_fine() const {
    return {-grid_.stride(2), -grid_.stride(1), -1, 1, grid_.stride(1), grid_.stride(2)};
  }

  const Partition& partition_;
  const VoxelGrid& coarse_;
  const std::vector<char>& is_atrial_;
  std::vector<char> marks_;      // of coarse voxels
  std::array<int, 3> origin_{};  // of the fine grid among coarse voxels
  VoxelGrid grid_;
  std::vector<int> slots_, places_;                // of the grid's voxels: in fine_, in voxels_
  std::vector<int> fine_, coarse_of_eight_;        // by slot, by slot / 8
  std::vector<std::array<std::uint8_t, 3>> free_;  // by slot, 0 where voxels are parted
  std::vector<std::array<bool, 3>> parted_;        // of the grid's voxels
  std::vector<BandVoxel> voxels_;
  LeastSurface surface_;
};

}  // namespace

CutBand cut_band(const Partition& partition, const VoxelGrid& coarse, const AtrialSide& side) {
  return BandBuilder(partition, coarse, side).result();
}

}  // namespace coapt
