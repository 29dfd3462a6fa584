#include "core/closure/crossing.h"

#include <algorithm>
#include <array>

namespace coapt {
namespace {

double signed_volume(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  return (b - a).cross(c - a).dot(d - a);
}

bool has_vertex(const Faces& faces, int f, int v) {
  return faces(f, 0) == v || faces(f, 1) == v || faces(f, 2) == v;
}

/// All their edges have a vertex in the other one: none pierces it.
bool share_edge(const Faces& faces, int f, int g) {
  int shared = 0;
  for (int k = 0; k < 3; ++k) shared += has_vertex(faces, g, faces(f, k));
  return shared >= 2;
}

struct Box {
  Vec3 low, high;
  int face = 0;
};

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
  std::vector<Box> boxes;
  for (int f = 0; f < faces.rows(); ++f) {
    const Vec3 a = x.row(faces(f, 0)), b = x.row(faces(f, 1)), c = x.row(faces(f, 2));
    boxes.push_back({a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c), f});
  }
  std::sort(boxes.begin(), boxes.end(), [](const Box& a, const Box& b) {
    return a.low.x() < b.low.x() || (a.low.x() == b.low.x() && a.face < b.face);
  });
  std::vector<std::pair<int, int>> crossings;
  for (auto box = boxes.begin(); box != boxes.end(); ++box) {
    const int f = box->face;
    for (auto other = box + 1; other != boxes.end() && other->low.x() <= box->high.x(); ++other) {
      const int g = other->face;
      if (other->low.y() > box->high.y() || other->high.y() < box->low.y() ||
          other->low.z() > box->high.z() || other->high.z() < box->low.z() ||
          share_edge(faces, f, g))
        continue;
      if (edge_pierces(faces, x, f, g) || edge_pierces(faces, x, g, f))
        crossings.push_back(std::minmax(f, g));
    }
  }
  std::sort(crossings.begin(), crossings.end());
  return crossings;
}

}  // namespace coapt
