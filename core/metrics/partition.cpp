#include "core/metrics/partition.h"

#include <algorithm>
#include <tuple>

namespace coapt {
namespace {

constexpr double kStrip_mm = 2.0;
constexpr double kBeyond_mm = 200.0;  // farther out than any grid

/// Which leaflets' triangles lie beside each other, and which touch a rim. The annulus is none: the strip goes on there.
void join(const Valve& valve, Partition& partition) {
  const Faces& faces = valve.faces;
  struct FaceEdge {
    int low, high, face, k;
  };
  std::vector<FaceEdge> edges;
  for (int f = 0; f < faces.rows(); ++f)
    for (int k = 0; k < 3; ++k) {
      const auto [low, high] = std::minmax({faces(f, k), faces(f, (k + 1) % 3)});
      edges.push_back({low, high, f, k});
    }
  std::sort(edges.begin(), edges.end(), [](const FaceEdge& a, const FaceEdge& b) {
    return std::tie(a.low, a.high, a.face) < std::tie(b.low, b.high, b.face);
  });
  auto& beyond = partition.beyond;
  beyond.assign(static_cast<std::size_t>(faces.rows()), {-1, -1, -1});
  for (std::size_t i = 1; i < edges.size(); ++i) {
    const FaceEdge &a = edges[i - 1], &b = edges[i];
    if (a.low != b.low || a.high != b.high) continue;
    beyond[static_cast<std::size_t>(a.face)][static_cast<std::size_t>(a.k)] = b.face;
    beyond[static_cast<std::size_t>(b.face)][static_cast<std::size_t>(b.k)] = a.face;
  }
  std::vector<char> is_rim(static_cast<std::size_t>(valve.rest_mm.rows()), 0);
  for (const FaceEdge& edge : edges)
    if (beyond[static_cast<std::size_t>(edge.face)][static_cast<std::size_t>(edge.k)] < 0)
      is_rim[static_cast<std::size_t>(edge.low)] = is_rim[static_cast<std::size_t>(edge.high)] = 1;
  for (const int vertex : valve.annulus) is_rim[static_cast<std::size_t>(vertex)] = 0;
  for (Index f = 0; f < faces.rows(); ++f)
    partition.touches_rim.push_back(is_rim[static_cast<std::size_t>(faces(f, 0))] |
                                    is_rim[static_cast<std::size_t>(faces(f, 1))] |
                                    is_rim[static_cast<std::size_t>(faces(f, 2))]);
}

}  // namespace

Partition partition_of(const Valve& valve, const Points& points_mm) {
  Partition partition;
  partition.half_thickness_mm = 0.5 * valve.tissue.thickness_mm;
  const auto at = [&](int vertex) { return Vec3(points_mm.row(vertex).transpose()); };
  for (Index f = 0; f < valve.faces.rows(); ++f)
    partition.leaflets.push_back(
        {at(valve.faces(f, 0)), at(valve.faces(f, 1)), at(valve.faces(f, 2))});
  join(valve, partition);
  const auto outwards = [](const Vec3& point, double way_mm) {
    const Vec2 direction = point.head<2>().normalized();
    return Vec3(point + way_mm * Vec3(direction.x(), direction.y(), 0.0));
  };
  for (std::size_t i = 0; i < valve.annulus.size(); ++i) {
    const Vec3 from = at(valve.annulus[i]), to = at(valve.annulus[(i + 1) % valve.annulus.size()]);
    const Vec3 from_strip = outwards(from, kStrip_mm), to_strip = outwards(to, kStrip_mm);
    partition.leaflets.push_back({from, to, to_strip});
    partition.leaflets.push_back({from, to_strip, from_strip});
    partition.walls.push_back({from_strip, to_strip, outwards(to, kBeyond_mm)});
    partition.walls.push_back({from_strip, outwards(to, kBeyond_mm), outwards(from, kBeyond_mm)});
  }
  partition.beyond.resize(partition.leaflets.size(), {-1, -1, -1});
  partition.touches_rim.resize(partition.leaflets.size(), 0);
  return partition;
}

}  // namespace coapt
