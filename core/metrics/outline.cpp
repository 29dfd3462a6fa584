#include "core/metrics/outline.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <utility>

#include "core/valve/types.h"

namespace coapt {
namespace {

using Edge = std::pair<int, int>;  // from, to

/// Sorted. One sort of numbers (lower vertex, higher vertex, direction) finds the edges that
/// cancel.
std::vector<Edge> unshared_edges(const std::vector<std::array<int, 3>>& faces) {
  std::vector<std::uint64_t> keys;
  keys.reserve(3 * faces.size());
  for (const std::array<int, 3>& face : faces)
    for (std::size_t i = 0; i < 3; ++i) {
      const auto from = static_cast<std::uint64_t>(face[i]);
      const auto to = static_cast<std::uint64_t>(face[(i + 1) % 3]);
      keys.push_back(from < to ? from << 33 | to << 1 : to << 33 | from << 1 | 1);
    }
  std::sort(keys.begin(), keys.end());
  std::vector<Edge> unshared;
  for (std::size_t i = 0; i < keys.size();) {
    const std::uint64_t vertices = keys[i] >> 1;
    int upwards = 0;  // how often it runs from its lower to its higher vertex, less the reverse
    for (; i < keys.size() && keys[i] >> 1 == vertices; ++i) upwards += keys[i] & 1 ? -1 : 1;
    const int low = static_cast<int>(vertices >> 32),
              high = static_cast<int>(vertices & 0xffffffff);
    const Edge edge = upwards > 0 ? Edge{low, high} : Edge{high, low};
    unshared.insert(unshared.end(), std::abs(upwards), edge);
  }
  std::sort(unshared.begin(), unshared.end());
  return unshared;
}

}  // namespace

std::vector<std::vector<int>> outline(const std::vector<std::array<int, 3>>& faces) {
  const std::vector<Edge> edges =
      unshared_edges(faces);  // sorted: those from one vertex lie together
  std::vector<bool> taken(edges.size(), false);
  const auto next_from = [&](int vertex) {
    Index edge = std::lower_bound(edges.begin(), edges.end(), Edge{vertex, -1}) - edges.begin();
    while (edge < std::ssize(edges) && edges[edge].first == vertex && taken[edge]) ++edge;
    return edge;
  };
  std::vector<std::vector<int>> walks;
  for (Index first = 0; first < std::ssize(edges); ++first) {
    if (taken[first]) continue;
    std::vector<int> walk;
    // As many edges end in a vertex as start there, so that a walk can only end where it began.
    for (Index edge = first;; edge = next_from(edges[edge].second)) {
      taken[edge] = true;
      walk.push_back(edges[edge].first);
      if (edges[edge].second == walk.front()) break;
    }
    walks.push_back(std::move(walk));
  }
  return walks;
}

}  // namespace coapt
