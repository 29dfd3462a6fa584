#include "core/metrics/voxels.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace coapt {
namespace {

constexpr int kSide = 8;  // points along a square's side
static_assert(kSide * kSide == kPointsOfSquare);
constexpr std::uint64_t kAll = ~std::uint64_t{0}, kRow = 0xff;
constexpr double kCrease = 0.42, kSmooth = 0.7;  // tan(45 deg / 2), cos(45 deg)
constexpr double kOnEdge =
    1e-9;  // of barycentric weights: a line through an edge meets both its faces

/// Points of a square, of side 1, at which constant + u a + v b < 0, with a and b from its centre.
std::uint64_t below_zero(double constant, double u, double v) {
  constexpr double kStep = 1.0 / kSide, kFirst = -0.5 * (kSide - 1) * kStep;
  double at_first = constant + (u + v) * kFirst;  // of a row; along it the value grows by u kStep
  std::uint64_t points = 0;
  if (u == 0.0) {
    for (int row = 0; row < kSide; ++row, at_first += v * kStep)
      if (at_first < 0.0) points |= kRow << (kSide * row);
    return points;
  }
  double root = -at_first / (u * kStep);
  const double change = -v / u;
  const std::uint64_t turned = u < 0.0 ? kRow : 0;
  for (int row = 0; row < kSide; ++row, root += change) {
    const int passed = static_cast<int>(std::min(std::max(root, -1.0), kSide - 1.0) + 1.0);
    points |= (((std::uint64_t{1} << passed) - 1) ^ turned) << (kSide * row);
  }
  return points;
}

/// A mid-surface's triangle. Lengths are counted in voxels, the first voxel's centre is the origin.
class TissueSheet {
 public:
  TissueSheet(const Corners& corners, const std::array<int, 3>& beyond, bool touches_rim,
              const VoxelGrid& grid)
      : beyond_(beyond), touches_rim_(touches_rim) {
    for (std::size_t k = 0; k < 3; ++k)
      corners_[k] = (corners[k] - grid.corner_mm) / grid.side_mm - Vec3::Constant(0.5);
    middle_ = (corners_[0] + corners_[1] + corners_[2]) / 3.0;
    for (std::size_t k = 0; k < 3; ++k) {
      edges_[k] = corners_[(k + 1) % 3] - corners_[k];
      squares_[k] = std::max(edges_[k].squaredNorm(), 1e-30);
      radius_ = std::max(radius_, (corners_[k] - middle_).norm());
    }
    normal_ = edges_[0].cross(-edges_[2]);
    const double twice_area = normal_.norm();
    if (twice_area > 0.0) normal_ /= twice_area;
    for (std::size_t k = 0; k < 3; ++k) {
      inwards_[k] = normal_.cross(edges_[k]);
      limits_[k] = inwards_[k].dot(corners_[k]);
      lengths_[k] = inwards_[k].norm();
    }
  }

  /// Calls act(place) for all voxels whose centres may be nearer than `reach`.
  /// @param row the first and the last x to look at on a row: row(y, z)
  template <class Row, class Act>
  void for_each_near(const VoxelGrid& grid, double reach, const Row& row, const Act& act) const {
    const auto range = [&](double low, double high, std::size_t axis) {
      return std::array{static_cast<int>(std::ceil(std::max(low, 0.0))),
                        static_cast<int>(std::floor(std::min(high, grid.size[axis] - 1.0)))};
    };
    const double around = radius_ + reach;
    const Vec3 least =
        corners_[0].cwiseMin(corners_[1]).cwiseMin(corners_[2]) - Vec3::Constant(reach);
    const Vec3 most =
        corners_[0].cwiseMax(corners_[1]).cwiseMax(corners_[2]) + Vec3::Constant(reach);
    const auto [first_z, last_z] = range(least.z(), most.z(), 2);
    const auto [first_y, last_y] = range(least.y(), most.y(), 1);
    const double of_x = normal_.x() != 0.0 ? 1.0 / normal_.x() : 0.0;
    for (int z = first_z; z <= last_z; ++z)
      for (int y = first_y; y <= last_y; ++y) {
        const auto [from, to] = row(y, z);
        if (from > to) continue;
        const double dy = y - middle_.y(), dz = z - middle_.z();
        const double left = around * around - dy * dy - dz * dz;
        if (left < 0.0) continue;
        const double chord = std::sqrt(left);
        double low = std::max(-chord, least.x() - middle_.x());  // from the middle
        double high = std::min(chord, most.x() - middle_.x());
        const double from_plane = normal_.y() * dy + normal_.z() * dz;
        if (of_x != 0.0) {
          low = std::max(low, -from_plane * of_x - reach * std::abs(of_x));
          high = std::min(high, -from_plane * of_x + reach * std::abs(of_x));
        } else if (std::abs(from_plane) > reach) {
          continue;
        }
        const auto [first_x, last_x] = range(middle_.x() + low, middle_.x() + high, 0);
        for (int x = std::max(first_x, from); x <= std::min(last_x, to); ++x)
          act(std::array{x, y, z});
      }
  }

  double height(const Vec3& point) const { return normal_.dot(point - middle_); }
  const Vec3& normal() const { return normal_; }
  const std::array<int, 3>& beyond() const { return beyond_; }

  bool is_over(const Vec3& point) const {
    return inwards_[0].dot(point) >= limits_[0] && inwards_[1].dot(point) >= limits_[1] &&
           inwards_[2].dot(point) >= limits_[2];
  }

  /// Whether the point lies over the triangle, or over a crease beside it: the farther away, the farther out.
  bool is_about_over(const Vec3& point, double height) const {
    const double slack = kCrease * std::abs(height);
    return inwards_[0].dot(point) >= limits_[0] - slack * lengths_[0] &&
           inwards_[1].dot(point) >= limits_[1] - slack * lengths_[1] &&
           inwards_[2].dot(point) >= limits_[2] - slack * lengths_[2];
  }

  /// Whether all that is near the triangle lies about over it or over those beside it: it touches no rim, and no edge is a sharp crease.
  bool is_smooth() const { return is_smooth_; }
  void look_beside(const std::vector<TissueSheet>& sheets) {
    is_smooth_ = !touches_rim_ && std::all_of(beyond_.begin(), beyond_.end(), [&](int beside) {
      return beside < 0 || sheets[static_cast<std::size_t>(beside)].normal_.dot(normal_) > kSmooth;
    });
  }

  /// To a point that the triangle does not lie under, from its nearest point.
  Vec3 from_edges(const Vec3& point) const {
    Vec3 best = Vec3::Zero();
    double best_square = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 from_corner = point - corners_[k];
      const double along = std::clamp(edges_[k].dot(from_corner) / squares_[k], 0.0, 1.0);
      const Vec3 way = from_corner - along * edges_[k];
      const double square = way.squaredNorm();
      if (square >= best_square) continue;
      best_square = square;
      best = way;
    }
    return best;
  }

 private:
  double radius_ = 0.0;
  Corners corners_;
  Vec3 normal_, middle_;
  std::array<Vec3, 3> edges_, inwards_;
  std::array<double, 3> squares_{}, limits_{}, lengths_{};
  std::array<int, 3> beyond_;
  bool touches_rim_, is_smooth_ = false;
};

std::vector<TissueSheet> sheets_of(const Partition& partition, const VoxelGrid& grid) {
  std::vector<TissueSheet> sheets;
  sheets.reserve(partition.leaflets.size());
  for (std::size_t i = 0; i < partition.leaflets.size(); ++i)
    sheets.emplace_back(partition.leaflets[i], partition.beyond[i], partition.touches_rim[i] != 0,
                        grid);
  for (TissueSheet& sheet : sheets) sheet.look_beside(sheets);
  return sheets;
}

/// Whether a sheet beside this one lies under the point, and is nearer to it.
bool is_over_another(const TissueSheet& sheet, const std::vector<TissueSheet>& sheets,
                     const Vec3& point) {
  return std::any_of(sheet.beyond().begin(), sheet.beyond().end(), [&](int beside) {
    return beside >= 0 && sheets[static_cast<std::size_t>(beside)].is_over(point);
  });
}

/// Points of a square across `axis` that are nearer to a plane than `half`.
/// @param distance of the square's centre; @param away from the plane, a unit vector
std::uint64_t covered_by_plane(double distance, const Vec3& away, int axis, double half) {
  const double u = away[(axis + 1) % 3], v = away[(axis + 2) % 3];
  const double change = 0.5 * (std::abs(u) + std::abs(v));
  if (distance - change >= half) return 0;
  if (distance + change < half && distance - change > -half) return kAll;
  const std::uint64_t on_this_side = below_zero(distance - half, u, v);
  return distance - change > -half ? on_this_side
                                   : on_this_side & below_zero(-distance - half, -u, -v);
}

/// Points of the squares beyond a voxel that the sheet covers, along x, y and z.
class SheetCover {
 public:
  SheetCover(const TissueSheet& sheet, const std::vector<TissueSheet>& sheets, double half)
      : sheet_(sheet), sheets_(sheets), half_(half) {}

  /// A smooth sheet covers all three as a plane; of others each square is looked at for itself.
  template <class Act>
  void of(const std::array<int, 3>& voxel, const Act& act) const {
    const Vec3 centre(voxel[0], voxel[1], voxel[2]);
    if (sheet_.is_smooth()) {
      const double height = sheet_.height(centre);
      if (!sheet_.is_over(centre) &&
          (!sheet_.is_about_over(centre, height) || is_over_another(sheet_, sheets_, centre)))
        return;
      const double sign = height < 0.0 ? -1.0 : 1.0;
      const Vec3 away = sign * sheet_.normal();
      for (int axis = 0; axis < 3; ++axis)
        act(axis, covered_by_plane(sign * height + 0.5 * away[axis], away, axis, half_));
      return;
    }
    for (int axis = 0; axis < 3; ++axis) act(axis, of_square(centre, axis));
  }

 private:
  std::uint64_t under(const TissueSheet& sheet, const Vec3& centre, int axis) const {
    const double height = sheet.height(centre);
    return covered_by_plane(std::abs(height), height < 0.0 ? Vec3(-sheet.normal()) : sheet.normal(),
                            axis, half_);
  }

  std::uint64_t of_square(const Vec3& voxel, int axis) const {
    Vec3 centre = voxel;
    centre[axis] += 0.5;
    const double reach = half_ + std::sqrt(0.5);
    if (sheet_.is_over(centre)) return under(sheet_, centre, axis);
    for (const int beside : sheet_.beyond()) {
      if (beside < 0) continue;
      const TissueSheet& other = sheets_[static_cast<std::size_t>(beside)];
      // A smooth one looks at voxels, not at squares.
      if (other.is_over(centre)) return other.is_smooth() ? under(other, centre, axis) : 0;
    }
    if (std::abs(sheet_.height(centre)) >= reach) return 0;
    const Vec3 way = sheet_.from_edges(centre);
    const double distance = way.norm();
    if (distance >= reach) return 0;
    return covered_by_plane(distance, distance > 1e-9 ? Vec3(way / distance) : sheet_.normal(),
                            axis, half_);
  }

  const TissueSheet& sheet_;
  const std::vector<TissueSheet>& sheets_;
  double half_;
};

void part(const Corners& corners, const VoxelGrid& grid, std::vector<std::array<bool, 3>>& parted) {
  std::array<Vec3, 3> at;  // in voxels, the first voxel's centre being the origin
  for (std::size_t k = 0; k < 3; ++k)
    at[k] = (corners[k] - grid.corner_mm) / grid.side_mm - Vec3::Constant(0.5);
  for (int axis = 0; axis < 3; ++axis) {
    const int a = (axis + 1) % 3, b = (axis + 2) % 3;
    const double twice_area = (at[1][a] - at[0][a]) * (at[2][b] - at[0][b]) -
                              (at[1][b] - at[0][b]) * (at[2][a] - at[0][a]);
    if (twice_area == 0.0) continue;
    const auto range = [&](int along) {
      const auto [low, high] = std::minmax({at[0][along], at[1][along], at[2][along]});
      const double end = grid.size[static_cast<std::size_t>(along)] - 1;
      return std::array{static_cast<int>(std::ceil(std::clamp(low, 0.0, end + 1))),
                        static_cast<int>(std::floor(std::clamp(high, -1.0, end)))};
    };
    const auto [first_a, last_a] = range(a);
    const auto [first_b, last_b] = range(b);
    for (int i = first_a; i <= last_a; ++i)
      for (int j = first_b; j <= last_b; ++j) {
        std::array<double, 3> weights{};
        for (std::size_t k = 0; k < 3; ++k) {
          const Vec3 &p = at[(k + 1) % 3], &q = at[(k + 2) % 3];
          weights[k] = ((p[a] - i) * (q[b] - j) - (p[b] - j) * (q[a] - i)) / twice_area;
        }
        if (std::min({weights[0], weights[1], weights[2]}) < -kOnEdge) continue;
        const double height =
            weights[0] * at[0][axis] + weights[1] * at[1][axis] + weights[2] * at[2][axis];
        if (!(height >= 0.0) || height >= grid.size[static_cast<std::size_t>(axis)] - 1) continue;
        std::array<int, 3> place{};
        place[static_cast<std::size_t>(axis)] = static_cast<int>(height);
        place[static_cast<std::size_t>(a)] = i;
        place[static_cast<std::size_t>(b)] = j;
        parted[static_cast<std::size_t>(grid.number(place))][static_cast<std::size_t>(axis)] = true;
      }
  }
}

}  // namespace

std::array<int, 3> VoxelGrid::place_of(const Vec3& point_mm) const {
  std::array<int, 3> place{};
  for (int axis = 0; axis < 3; ++axis) {
    const auto k = static_cast<std::size_t>(axis);
    const double at = std::floor((point_mm[axis] - corner_mm[axis]) / side_mm);
    place[k] = static_cast<int>(std::clamp(at, 0.0, size[k] - 1.0));
  }
  return place;
}

VoxelGrid voxels_over(const Vec3& low_mm, const Vec3& high_mm, double side_mm) {
  VoxelGrid grid{low_mm, side_mm, {}};
  for (int axis = 0; axis < 3; ++axis)
    grid.size[static_cast<std::size_t>(axis)] =
        static_cast<int>(std::ceil((high_mm[axis] - low_mm[axis]) / side_mm)) + 1;
  return grid;
}

std::vector<std::array<bool, 3>> partings(const Partition& partition, const VoxelGrid& grid) {
  std::vector<std::array<bool, 3>> parted(static_cast<std::size_t>(grid.count()),
                                          {false, false, false});
  for (const Corners& corners : partition.leaflets) part(corners, grid, parted);
  for (const Corners& corners : partition.walls) part(corners, grid, parted);
  return parted;
}

std::vector<float> clearances_mm(const Partition& partition, const VoxelGrid& grid,
                                 double limit_mm) {
  const double limit = limit_mm / grid.side_mm;
  std::vector<float> squares(static_cast<std::size_t>(grid.count()),
                             static_cast<float>(limit * limit));
  const auto whole_row = [&](int, int) { return std::array{0, grid.size[0] - 1}; };
  const std::vector<TissueSheet> sheets = sheets_of(partition, grid);
  for (const TissueSheet& sheet : sheets) {
    const bool is_smooth = sheet.is_smooth();
    sheet.for_each_near(grid, limit, whole_row, [&](const std::array<int, 3>& voxel) {
      const Vec3 centre(voxel[0], voxel[1], voxel[2]);
      const double height = sheet.height(centre);
      float& nearest = squares[static_cast<std::size_t>(grid.number(voxel))];
      if (height * height >= static_cast<double>(nearest)) return;
      double square = height * height;
      if (!sheet.is_over(centre)) {
        if ((is_smooth && !sheet.is_about_over(centre, height)) ||
            is_over_another(sheet, sheets, centre))
          return;
        if (!is_smooth) square = sheet.from_edges(centre).squaredNorm();
      }
      nearest = std::min(nearest, static_cast<float>(square));
    });
  }
  for (float& value : squares) value = std::sqrt(value) * static_cast<float>(grid.side_mm);
  return squares;
}

std::vector<std::array<std::uint8_t, 3>> free_points(const Partition& partition,
                                                     const VoxelGrid& grid,
                                                     const std::vector<int>& slots, int count) {
  const double half = partition.half_thickness_mm / grid.side_mm;
  const double reach = half + std::sqrt(0.5) + 0.5;  // from a voxel's centre past its squares
  std::vector<std::array<std::uint64_t, 3>> covered(static_cast<std::size_t>(count), {0, 0, 0});
  std::vector<std::array<int, 2>> rows(static_cast<std::size_t>(grid.size[1] * grid.size[2]),
                                       {grid.size[0], -1});
  for (std::size_t voxel = 0; voxel < slots.size(); ++voxel) {
    if (slots[voxel] < 0) continue;
    const int x = static_cast<int>(voxel) % grid.size[0];
    auto& [from, to] = rows[voxel / static_cast<std::size_t>(grid.size[0])];
    from = std::min(from, x);
    to = x;
  }
  const auto row = [&](int y, int z) {
    return rows[static_cast<std::size_t>(z * grid.size[1] + y)];
  };
  const std::vector<TissueSheet> sheets = sheets_of(partition, grid);
  for (const TissueSheet& sheet : sheets) {
    const SheetCover cover(sheet, sheets, half);
    sheet.for_each_near(grid, reach, row, [&](const std::array<int, 3>& voxel) {
      const int slot = slots[static_cast<std::size_t>(grid.number(voxel))];
      if (slot < 0) return;
      auto& squares = covered[static_cast<std::size_t>(slot)];
      if ((squares[0] & squares[1] & squares[2]) == kAll) return;
      cover.of(voxel, [&](int axis, std::uint64_t points) {
        squares[static_cast<std::size_t>(axis)] |= points;
      });
    });
  }
  std::vector<std::array<std::uint8_t, 3>> free(covered.size());
  for (std::size_t i = 0; i < covered.size(); ++i)
    for (std::size_t axis = 0; axis < 3; ++axis)
      free[i][axis] = static_cast<std::uint8_t>(kPointsOfSquare - std::popcount(covered[i][axis]));
  return free;
}

}  // namespace coapt
