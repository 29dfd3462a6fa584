#include "core/closure/crossing.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace coapt {
namespace {

double signed_volume(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  return (b - a).cross(c - a).dot(d - a);
}

bool has_vertex(const Faces& faces, int f, int v) {
  return faces(f, 0) == v || faces(f, 1) == v || faces(f, 2) == v;
}

}  // namespace

bool edge_pierces(const Faces& faces, const Points& x, int f, int g) {
  const Vec3 a = x.row(faces(g, 0)), b = x.row(faces(g, 1)), c = x.row(faces(g, 2));
  const Vec3 normal = (b - a).cross(c - a);
  std::array<double, 3> height;
  for (int k = 0; k < 3; ++k) height[k] = normal.dot(Vec3(x.row(faces(f, k))) - a);
  for (int k = 0; k < 3; ++k) {
    const int i = faces(f, k), j = faces(f, (k + 1) % 3);
    const double above = height[k], below = height[(k + 1) % 3];
    if ((above > 0.0) == (below > 0.0) || above == 0.0 || below == 0.0) continue;
    if (has_vertex(faces, g, i) || has_vertex(faces, g, j)) continue;
    const Vec3 p = x.row(i), q = x.row(j);
    const double u = signed_volume(p, q, a, b), v = signed_volume(p, q, b, c),
                 w = signed_volume(p, q, c, a);
    if ((u > 0.0 && v > 0.0 && w > 0.0) || (u < 0.0 && v < 0.0 && w < 0.0)) return true;
  }
  return false;
}

std::vector<std::pair<int, int>> crossing_pairs(const Faces& faces, const Points& x) {
  Points low(faces.rows(), 3), high(faces.rows(), 3);
  for (Index f = 0; f < faces.rows(); ++f) {
    const auto a = x.row(faces(f, 0)), b = x.row(faces(f, 1)), c = x.row(faces(f, 2));
    low.row(f) = a.cwiseMin(b).cwiseMin(c);
    high.row(f) = a.cwiseMax(b).cwiseMax(c);
  }
  std::vector<int> order(faces.rows());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](int f, int g) {
    return low(f, 0) < low(g, 0) || (low(f, 0) == low(g, 0) && f < g);
  });
  std::vector<std::pair<int, int>> crossings;
  for (std::size_t m = 0; m < order.size(); ++m) {
    const int f = order[m];
    for (std::size_t n = m + 1; n < order.size() && low(order[n], 0) <= high(f, 0); ++n) {
      const int g = order[n];
      if (low(g, 1) > high(f, 1) || high(g, 1) < low(f, 1) || low(g, 2) > high(f, 2) ||
          high(g, 2) < low(f, 2))
        continue;
      if (edge_pierces(faces, x, f, g) || edge_pierces(faces, x, g, f))
        crossings.push_back(std::minmax(f, g));
    }
  }
  std::sort(crossings.begin(), crossings.end());
  return crossings;
}

}  // namespace coapt
