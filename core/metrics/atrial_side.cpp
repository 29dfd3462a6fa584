#include "core/metrics/atrial_side.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace coapt {
namespace {

constexpr double kOpen_mm = 2.0;
constexpr int kDirections = 6;  // to the next voxel along x, back, along y, back, along z, back
constexpr int kFree = 64;       // what flows through where nothing is in the way
constexpr int kUnbounded = 1 << 28, kTowardsVentricle = kDirections + 1;

int opposite(int direction) { return direction ^ 1; }

enum class Kind : char { Between, Open, Atrium, Ventricle, Wall };

/// The voxels, and what flows from each to its neighbours.
class Blood {
 public:
  Blood(const Partition& partition, const VoxelGrid& grid)
      : parted_(partings(partition, grid)),
        clearances_mm_(
            clearances_mm(partition, grid, partition.half_thickness_mm + 0.5 * grid.side_mm)),
        half_mm_(static_cast<float>(partition.half_thickness_mm)),
        per_mm_(static_cast<float>(kFree / grid.side_mm)) {
    for (int axis = 0; axis < 3; ++axis) {
      steps_[2 * static_cast<std::size_t>(axis)] = grid.stride(axis);
      steps_[2 * static_cast<std::size_t>(axis) + 1] = -grid.stride(axis);
    }
  }

  /// @pre the voxel is in none of the grid's outermost layers
  int next(int voxel, int direction) const {
    return voxel + steps_[static_cast<std::size_t>(direction)];
  }

  bool is_parted(int voxel, int direction) const {
    const int lower = direction % 2 == 0 ? voxel : next(voxel, direction);
    return parted_[static_cast<std::size_t>(lower)][static_cast<std::size_t>(direction / 2)];
  }

  int lets_through(int voxel, int direction) const {
    if (is_parted(voxel, direction)) return 0;
    const float both = clearances_mm_[static_cast<std::size_t>(voxel)] +
                       clearances_mm_[static_cast<std::size_t>(next(voxel, direction))];
    return static_cast<int>(
        std::clamp((both - 2.0f * half_mm_) * per_mm_, 0.0f, static_cast<float>(kFree)));
  }

 private:
  std::vector<std::array<bool, 3>> parted_;
  std::vector<float> clearances_mm_;
  float half_mm_, per_mm_;
  std::array<int, kDirections> steps_{};
};

/// Calls act(voxel) for all that are in none of the grid's outermost layers.
template <class Act>
void for_each_inner(const VoxelGrid& grid, const Act& act) {
  for (int z = 1; z + 1 < grid.size[2]; ++z)
    for (int y = 1; y + 1 < grid.size[1]; ++y)
      for (int x = 1; x + 1 < grid.size[0]; ++x) act(grid.number({x, y, z}));
}

/// Atrium, ventricle and what is reached from either through open voxels.
std::vector<Kind> kinds_of(const Partition& partition, const VoxelGrid& grid, const Blood& blood) {
  const int layer = grid.stride(2);
  std::vector<Kind> kinds(static_cast<std::size_t>(grid.count()), Kind::Wall);
  for_each_inner(grid, [&](int voxel) { kinds[static_cast<std::size_t>(voxel)] = Kind::Open; });
  for (const Corners& corners : partition.leaflets) {
    const Vec3 low = corners[0].cwiseMin(corners[1]).cwiseMin(corners[2]);
    const Vec3 high = corners[0].cwiseMax(corners[1]).cwiseMax(corners[2]);
    const auto first = grid.place_of(low - Vec3::Constant(kOpen_mm));
    const auto last = grid.place_of(high + Vec3::Constant(kOpen_mm));
    for (int z = std::max(first[2], 1); z <= std::min(last[2], grid.size[2] - 2); ++z)
      for (int y = std::max(first[1], 1); y <= std::min(last[1], grid.size[1] - 2); ++y)
        for (int x = std::max(first[0], 1); x <= std::min(last[0], grid.size[0] - 2); ++x)
          kinds[static_cast<std::size_t>(grid.number({x, y, z}))] = Kind::Between;
  }
  // The layers inside the first and the last are the ventricle and the atrium.
  const std::vector<Kind> apart = kinds;
  std::vector<int> reached;
  bool meet = false;
  const auto flood = [&](Kind side, int first) {
    reached.clear();
    for (int voxel = first; voxel < first + layer; ++voxel)
      if (apart[static_cast<std::size_t>(voxel)] != Kind::Wall) {
        kinds[static_cast<std::size_t>(voxel)] = side;
        reached.push_back(voxel);
      }
    for (std::size_t i = 0; i < reached.size(); ++i)
      for (int direction = 0; direction < kDirections; ++direction) {
        Kind& kind = kinds[static_cast<std::size_t>(blood.next(reached[i], direction))];
        if (kind == side || kind == Kind::Wall || kind == Kind::Between ||
            blood.lets_through(reached[i], direction) < kFree)
          continue;
        meet = meet || kind != Kind::Open;
        if (kind != Kind::Open) continue;
        kind = side;
        reached.push_back(blood.next(reached[i], direction));
      }
  };
  flood(Kind::Ventricle, layer);
  flood(Kind::Atrium, grid.count() - 2 * layer);
  if (meet)
    for (int voxel = 2 * layer; voxel < grid.count() - 2 * layer; ++voxel) {
      Kind& kind = kinds[static_cast<std::size_t>(voxel)];
      if (kind != Kind::Wall) kind = Kind::Open;
    }
  for (Kind& kind : kinds)
    if (kind == Kind::Open) kind = Kind::Between;
  return kinds;
}

/// Flow from the atrium to the ventricle through the voxels between them.
class Flow {
 public:
  Flow(const Blood& blood, const std::vector<Kind>& kinds) : node_of_(kinds.size(), -1) {
    for (std::size_t v = 0; v < kinds.size(); ++v)
      if (kinds[v] == Kind::Between) {
        node_of_[v] = static_cast<int>(voxels_.size());
        voxels_.push_back(static_cast<int>(v));
      }
    nodes_.resize(voxels_.size());
    levels_.resize(voxels_.size(), -1);
    tried_.resize(voxels_.size(), 0);
    for (std::size_t i = 0; i < voxels_.size(); ++i) {
      Node& node = nodes_[i];
      for (int direction = 0; direction < kDirections; ++direction) {
        const auto to = static_cast<std::size_t>(blood.next(voxels_[i], direction));
        if (kinds[to] == Kind::Wall) continue;
        const int through = blood.lets_through(voxels_[i], direction);
        if (kinds[to] == Kind::Atrium) {
          node.from_atrium += through;
        } else if (kinds[to] == Kind::Ventricle) {
          node.to_ventricle += through;
        } else {
          node.next[static_cast<std::size_t>(direction)] = node_of_[to];
          node.left[static_cast<std::size_t>(direction)] = through;
        }
      }
      if (node.from_atrium > 0) entries_.push_back(static_cast<int>(i));
    }
  }

  void run() {
    while (reach_ventricle()) {
      std::fill(tried_.begin(), tried_.end(), 0);
      for (const int entry : entries_)
        while (at(entry).from_atrium > 0) {
          const int passed = pass(entry, at(entry).from_atrium);
          if (passed == 0) break;
          at(entry).from_atrium -= passed;
        }
    }
  }

  /// After run(): adds the voxels to which more could flow from the atrium, and those from which more could flow to the ventricle.
  void add_sides(std::vector<Kind>& kinds) {
    queue_.clear();
    for (std::size_t i = 0; i < nodes_.size(); ++i)
      if (nodes_[i].to_ventricle > 0) {
        tried_[i] = kTowardsVentricle;
        queue_.push_back(static_cast<int>(i));
      }
    for (std::size_t i = 0; i < queue_.size(); ++i)
      for (int direction = 0; direction < kDirections; ++direction) {
        const int from = at(queue_[i]).next[static_cast<std::size_t>(direction)];
        if (from < 0 || tried_[static_cast<std::size_t>(from)] == kTowardsVentricle ||
            at(from).left[static_cast<std::size_t>(opposite(direction))] == 0)
          continue;
        tried_[static_cast<std::size_t>(from)] = kTowardsVentricle;
        queue_.push_back(from);
      }
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      Kind& kind = kinds[static_cast<std::size_t>(voxels_[i])];
      if (levels_[i] >= 0) kind = Kind::Atrium;
      if (tried_[i] == kTowardsVentricle) kind = Kind::Ventricle;
    }
  }

 private:
  struct Node {
    std::array<int, kDirections> next{-1, -1, -1, -1, -1, -1};
    std::array<int, kDirections> left{};  // what may still flow there
    int from_atrium = 0, to_ventricle = 0;
  };

  int& level(int node) { return levels_[static_cast<std::size_t>(node)]; }
  Node& at(int node) { return nodes_[static_cast<std::size_t>(node)]; }

  /// Levels from the atrium on, as far as the nearest nodes beside the ventricle. @return whether there are any
  bool reach_ventricle() {
    std::fill(levels_.begin(), levels_.end(), -1);
    queue_.clear();
    for (const int entry : entries_)
      if (at(entry).from_atrium > 0) {
        level(entry) = 0;
        queue_.push_back(entry);
      }
    int last = kUnbounded;
    for (std::size_t i = 0; i < queue_.size(); ++i) {
      const Node& node = at(queue_[i]);
      const int own = level(queue_[i]);
      if (own > last) break;
      if (node.to_ventricle > 0) last = own;
      for (std::size_t d = 0; d < kDirections; ++d)
        if (node.left[d] > 0 && level(node.next[d]) < 0) {
          level(node.next[d]) = own + 1;
          queue_.push_back(node.next[d]);
        }
    }
    return last < kUnbounded;
  }

  int pass(int from, int most) {
    Node& node = at(from);
    if (node.to_ventricle > 0) {
      const int passed = std::min(most, node.to_ventricle);
      node.to_ventricle -= passed;
      return passed;
    }
    for (int& tried = tried_[static_cast<std::size_t>(from)]; tried < kDirections; ++tried) {
      const auto d = static_cast<std::size_t>(tried);
      if (node.left[d] == 0 || level(node.next[d]) != level(from) + 1) continue;
      const int passed = pass(node.next[d], std::min(most, node.left[d]));
      if (passed == 0) continue;
      node.left[d] -= passed;
      at(node.next[d]).left[static_cast<std::size_t>(opposite(tried))] += passed;
      return passed;
    }
    return 0;
  }

  std::vector<int> node_of_;  // -1: none
  std::vector<int> voxels_;   // of nodes
  std::vector<Node> nodes_;
  std::vector<int> levels_, tried_;  // of nodes
  std::vector<int> entries_, queue_;
};

/// Gives what neither side has reached to the side from which fewer covered steps lead there.
void share_out(const VoxelGrid& grid, const Blood& blood, std::vector<Kind>& kinds) {
  const std::array<Kind, 2> sides{Kind::Atrium, Kind::Ventricle};
  std::array<std::vector<int>, 2> reached;
  for_each_inner(grid, [&](int voxel) {
    if (kinds[static_cast<std::size_t>(voxel)] != Kind::Between) return;
    for (int direction = 0; direction < kDirections; ++direction) {
      const int beside = blood.next(voxel, direction);
      for (std::size_t s = 0; s < sides.size(); ++s)
        if (kinds[static_cast<std::size_t>(beside)] == sides[s]) reached[s].push_back(beside);
    }
  });
  while (!reached[0].empty() || !reached[1].empty()) {
    std::array<std::vector<int>, 2> beyond;  // by a covered step
    for (std::size_t s = 0; s < sides.size(); ++s)
      for (std::size_t i = 0; i < reached[s].size(); ++i)
        for (int direction = 0; direction < kDirections; ++direction) {
          const int to = blood.next(reached[s][i], direction);
          if (kinds[static_cast<std::size_t>(to)] != Kind::Between ||
              blood.is_parted(reached[s][i], direction))
            continue;
          if (blood.lets_through(reached[s][i], direction) == 0) {
            beyond[s].push_back(to);
            continue;
          }
          kinds[static_cast<std::size_t>(to)] = sides[s];
          reached[s].push_back(to);
        }
    for (std::size_t s = 0; s < sides.size(); ++s) {
      reached[s].clear();
      for (const int voxel : beyond[s]) {
        Kind& kind = kinds[static_cast<std::size_t>(voxel)];
        if (kind != Kind::Between) continue;
        kind = sides[s];
        reached[s].push_back(voxel);
      }
    }
  }
}

}  // namespace

AtrialSide atrial_side(const Partition& partition, const VoxelGrid& grid) {
  const Blood blood(partition, grid);
  std::vector<Kind> kinds = kinds_of(partition, grid, blood);
  Flow flow(blood, kinds);
  flow.run();
  flow.add_sides(kinds);
  share_out(grid, blood, kinds);

  AtrialSide side;
  side.is_atrial.resize(kinds.size());
  for (std::size_t v = 0; v < kinds.size(); ++v) side.is_atrial[v] = kinds[v] == Kind::Atrium;
  for_each_inner(grid, [&](int voxel) {
    for (int axis = 0; axis < 3; ++axis) {
      const int to = blood.next(voxel, 2 * axis);
      if (kinds[static_cast<std::size_t>(to)] != Kind::Wall && !blood.is_parted(voxel, 2 * axis) &&
          side.is_atrial[static_cast<std::size_t>(voxel)] !=
              side.is_atrial[static_cast<std::size_t>(to)])
        side.cut.push_back({voxel, axis});
    }
  });
  return side;
}

}  // namespace coapt
