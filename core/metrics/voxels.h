// Voxels of blood about the leaflets: which are parted from each other, how far they are from tissue, and how much of the square
// between two of them is free.
//
// Tissue is the leaflets' mid-surfaces with half the thickness on either face. A square, as wide as a voxel, stands half way between
// the centres of two neighbours; of 8 x 8 points on it those are free that no face is nearer to than half the thickness. Over
// one square a face's distance is taken as linear, exact for flat sheets. Where a face or a wall passes between two centres they
// are parted, so that no sheet leaks, however thin it is or wide the voxels are.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/metrics/partition.h"
#include "core/valve/types.h"

namespace coapt {

struct VoxelGrid {
  Vec3 corner_mm = Vec3::Zero();
  double side_mm = 1.0;
  std::array<int, 3> size{};

  int count() const { return size[0] * size[1] * size[2]; }
  /// From a voxel's number to that of the next along the axis.
  int stride(int axis) const { return axis == 0 ? 1 : axis == 1 ? size[0] : size[0] * size[1]; }
  int number(const std::array<int, 3>& place) const {
    return (place[2] * size[1] + place[1]) * size[0] + place[0];
  }
  std::array<int, 3> place(int number) const {
    return {number % size[0], number / size[0] % size[1], number / (size[0] * size[1])};
  }
  Vec3 centre_mm(const std::array<int, 3>& place) const {
    return corner_mm + side_mm * (Vec3(place[0], place[1], place[2]) + Vec3::Constant(0.5));
  }
  /// Of the voxel that holds the point, or of the nearest one.
  std::array<int, 3> place_of(const Vec3& point_mm) const;
};

/// Voxels from `low_mm` to `high_mm` at least.
VoxelGrid voxels_over(const Vec3& low_mm, const Vec3& high_mm, double side_mm);

/// Of every voxel and axis, whether the partition passes between its centre and that of the next voxel.
std::vector<std::array<bool, 3>> partings(const Partition& partition, const VoxelGrid& grid);

/// Of every voxel's centre, its distance from the nearest mid-surface; those that are farther have `limit_mm`.
std::vector<float> clearances_mm(const Partition& partition, const VoxelGrid& grid,
                                 double limit_mm);

inline constexpr int kPointsOfSquare = 64;

/// Of some voxels and axes, how many points of the square to the next voxel are free; whatever parts its voxels is not looked at.
/// @param slots one a voxel of the grid: where it stands in the result, -1 for those that are left out
/// @param count of slots that are given
std::vector<std::array<std::uint8_t, 3>> free_points(const Partition& partition,
                                                     const VoxelGrid& grid,
                                                     const std::vector<int>& slots, int count);

}  // namespace coapt
