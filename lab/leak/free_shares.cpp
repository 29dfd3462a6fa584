#include "lab/leak/free_shares.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "core/closure/contact.h"

namespace coapt {
namespace {

constexpr int kPointsAcross = 4;  // of a face: 16 points, one bit each
constexpr std::uint16_t kAllFree = 0xffff;
constexpr double kHalfDiagonal = 0.7072;  // of a face one voxel wide

struct FaceCorners {
  Vec3 a, b, c;

  double distance_mm(const Vec3& point) const {
    const Vec3 w = closest_point_weights(point, a, b, c);
    return (point - w[0] * a - w[1] * b - w[2] * c).norm();
  }
};

class FacePoints {
 public:
  FacePoints(const VoxelBand& band, double half_mm) : band_(band), half_mm_(half_mm) {
    for (auto& free : free_) free.assign(static_cast<std::size_t>(band.cells) + 1, kAllFree);
  }

  /// Takes away what is within half a thickness of a triangle.
  void cover(const FaceCorners& triangle) {
    const auto [low, high] = cells_near(triangle);
    for (int k = low[2]; k <= high[2]; ++k)
      for (int j = low[1]; j <= high[1]; ++j) {
        const auto [begin, end] = band_.row(j, k);
        for (const VoxelRun* run = begin; run != end; ++run)
          for (int i = std::max(low[0], run->begin); i <= std::min(high[0], run->end - 1); ++i)
            cover(triangle, {i, j, k}, static_cast<std::size_t>(run->first + i - run->begin));
      }
  }

  float share(std::size_t axis, int index) const {
    return static_cast<float>(std::popcount(free_[axis][static_cast<std::size_t>(index)])) /
           (kPointsAcross * kPointsAcross);
  }

 private:
  double voxel_mm() const { return band_.lattice.voxel_mm; }

  std::pair<Cell, Cell> cells_near(const FaceCorners& triangle) const {
    const VoxelLattice& lattice = band_.lattice;
    const double reach_mm = half_mm_ + voxel_mm();
    const Vec3 low_mm = triangle.a.cwiseMin(triangle.b).cwiseMin(triangle.c);
    const Vec3 high_mm = triangle.a.cwiseMax(triangle.b).cwiseMax(triangle.c);
    Cell low, high;
    for (int axis = 0; axis < 3; ++axis) {
      const auto column = [&](double at_mm) {
        const double last = lattice.size[static_cast<std::size_t>(axis)] - 1.0;
        return static_cast<int>(
            std::clamp(std::floor((at_mm - lattice.low_mm[axis]) / voxel_mm()), 0.0, last));
      };
      low[static_cast<std::size_t>(axis)] = column(low_mm[axis] - reach_mm);
      high[static_cast<std::size_t>(axis)] = column(high_mm[axis] + reach_mm);
    }
    return {low, high};
  }

  void cover(const FaceCorners& triangle, const Cell& cell, std::size_t index) {
    if (!(free_[0][index] | free_[1][index] | free_[2][index])) return;
    const Vec3 centre_mm = band_.lattice.centre_mm(cell);
    if (triangle.distance_mm(centre_mm) > half_mm_ + (0.5 + kHalfDiagonal) * voxel_mm()) return;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      std::uint16_t& free = free_[axis][index];
      if (!free) continue;
      Vec3 middle_mm = centre_mm;
      middle_mm[static_cast<int>(axis)] += 0.5 * voxel_mm();
      const double distance_mm = triangle.distance_mm(middle_mm);
      if (distance_mm > half_mm_ + kHalfDiagonal * voxel_mm()) continue;
      free = distance_mm < half_mm_ - kHalfDiagonal * voxel_mm()
                 ? std::uint16_t{0}
                 : still_free(triangle, middle_mm, axis, free);
    }
  }

  std::uint16_t still_free(const FaceCorners& triangle, const Vec3& middle_mm, std::size_t axis,
                           std::uint16_t free) const {
    const int one = static_cast<int>((axis + 1) % 3), other = static_cast<int>((axis + 2) % 3);
    const auto off_mm = [&](int at) { return voxel_mm() * ((at + 0.5) / kPointsAcross - 0.5); };
    unsigned left = free;
    for (int bit = 0; bit < kPointsAcross * kPointsAcross; ++bit) {
      if (!(left >> bit & 1U)) continue;
      Vec3 point_mm = middle_mm;
      point_mm[one] += off_mm(bit % kPointsAcross);
      point_mm[other] += off_mm(bit / kPointsAcross);
      if (triangle.distance_mm(point_mm) < half_mm_) left &= ~(1U << bit);
    }
    return static_cast<std::uint16_t>(left);
  }

  const VoxelBand& band_;
  double half_mm_;
  std::array<std::vector<std::uint16_t>, 3> free_;  // by index: bits of the face's points
};

}  // namespace

AxisFields free_shares(const VoxelBand& band, const LeakSurface& surface) {
  FacePoints points(band, surface.half_thickness_mm);
  for (Index f = 0; f < surface.faces.rows(); ++f) {
    const auto corner = [&](int k) -> Vec3 { return surface.points_mm.row(surface.faces(f, k)); };
    points.cover({corner(0), corner(1), corner(2)});
  }
  AxisFields shares;
  shares.fill(std::vector<float>(static_cast<std::size_t>(band.cells) + 2, 0.0F));
  for_each_cell(band, [&](const Cell& cell, int index) {
    const auto at = static_cast<std::size_t>(index);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      Cell next = cell;
      ++next[axis];
      const int neighbour = band.find(next);
      if (neighbour == 0) continue;
      if (band.is_fixed[at] && band.is_fixed[static_cast<std::size_t>(neighbour)]) continue;
      shares[axis][at] = points.share(axis, index);
    }
  });
  return shares;
}

}  // namespace coapt
