#include "core/metrics/silhouette.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

#include "core/metrics/outline.h"
#include "core/metrics/plane_grid.h"

namespace coapt {
namespace {

/// Narrower faces can vanish in the union's rounding: their longest edge is grown apart from it.
constexpr double kEdgeOn_mm = 1e-4;

/// Twice the area, exact, positive when counter-clockwise.
std::int64_t turn(const GridPoint& a, const GridPoint& b, const GridPoint& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Appends the longest edge of a face that is seen edge-on.
void add_if_edge_on(std::vector<std::vector<Vec2>>& lines_mm,
                    const std::array<GridPoint, 3>& corners, double twice_area) {
  double longest_squared = 0.0;
  std::size_t longest = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const GridPoint &a = corners[i], &b = corners[(i + 1) % 3];
    const double x = static_cast<double>(b.x - a.x), y = static_cast<double>(b.y - a.y);
    if (x * x + y * y > longest_squared) {
      longest_squared = x * x + y * y;
      longest = i;
    }
  }
  constexpr double kWidth = kEdgeOn_mm * kGridPerMm;
  if (twice_area * twice_area <= kWidth * kWidth * longest_squared)
    lines_mm.push_back({from_grid(corners[longest]), from_grid(corners[(longest + 1) % 3])});
}

}  // namespace

FlatTissue silhouette(const Valve& valve, const Projection& projection) {
  std::vector<std::array<int, 3>> towards, away;
  std::vector<Vec2> grid_mm(valve.rest_mm.rows());
  FlatTissue tissue;
  for (std::size_t f = 0; f < projection.faces.size(); ++f) {
    std::array<int, 3> face = {valve.faces(f, 0), valve.faces(f, 1), valve.faces(f, 2)};
    std::array<GridPoint, 3> corners;
    for (std::size_t i = 0; i < 3; ++i) {
      corners[i] = to_grid(projection.faces[f][i]);
      grid_mm[face[i]] = from_grid(corners[i]);
    }
    const std::int64_t twice_area = turn(corners[0], corners[1], corners[2]);
    add_if_edge_on(tissue.lines_mm, corners, std::abs(static_cast<double>(twice_area)));
    if (twice_area < 0) std::swap(face[1], face[2]);
    if (twice_area != 0) (twice_area > 0 ? towards : away).push_back(face);
  }
  for (const auto* faces : {&towards, &away})
    for (const std::vector<int>& walk : outline(*faces)) {
      std::vector<Vec2>& outline_mm = tissue.outlines_mm.emplace_back();
      for (const int vertex : walk) outline_mm.push_back(grid_mm[vertex]);
    }
  return tissue;
}

}  // namespace coapt
