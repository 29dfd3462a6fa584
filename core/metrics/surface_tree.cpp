#include "core/metrics/surface_tree.h"

#include <algorithm>
#include <map>
#include <utility>

#include "core/closure/contact.h"

namespace coapt {
namespace {

constexpr int kTrianglesInLeaf = 8;
constexpr std::size_t kDeepest = 64;  // halves of 2^31 triangles are 31 deep
constexpr double kFar = std::numeric_limits<double>::infinity();

double squared_distance(const Vec3& low, const Vec3& high, const Vec3& point) {
  double sum = 0.0;
  for (int k = 0; k < 3; ++k) {
    const double beside = std::max(std::max(low[k] - point[k], point[k] - high[k]), 0.0);
    sum += beside * beside;
  }
  return sum;
}

/// Where a ray enters a box; infinity where it misses.
double entry_mm(const Vec3& low, const Vec3& high, const Vec3& from_mm, const Vec3& direction) {
  double enters = 0.0, leaves = kFar;
  for (int k = 0; k < 3; ++k) {
    if (direction[k] == 0.0) {
      if (from_mm[k] < low[k] || from_mm[k] > high[k]) return kFar;
      continue;
    }
    double near = (low[k] - from_mm[k]) / direction[k], far = (high[k] - from_mm[k]) / direction[k];
    if (near > far) std::swap(near, far);
    enters = std::max(enters, near);
    leaves = std::min(leaves, far);
  }
  return enters <= leaves ? enters : kFar;
}

bool is_nearer(double distance_mm, int face, const TreePoint& than) {
  return distance_mm < than.distance_mm || (distance_mm == than.distance_mm && face < than.face);
}

void try_triangle(const Vec3& point, const std::array<Vec3, 3>& corners_mm, int face,
                  TreePoint& nearest) {
  const auto& [a, b, c] = corners_mm;
  const Vec3 weights = closest_point_weights(point, a, b, c);
  const Vec3 at = weights[0] * a + weights[1] * b + weights[2] * c;
  const double away = (point - at).norm();
  if (is_nearer(away, face, nearest)) nearest = {face, weights, at, away};
}

std::array<Vec3, 3> corners_of(const Points& vertices_mm, const Faces& faces, int face) {
  return {vertices_mm.row(faces(face, 0)), vertices_mm.row(faces(face, 1)),
          vertices_mm.row(faces(face, 2))};
}

}  // namespace

SurfaceTree::SurfaceTree(Points vertices_mm, Faces faces)
    : vertices_mm_(std::move(vertices_mm)), faces_(std::move(faces)) {
  const int count = static_cast<int>(faces_.rows());
  triangles_.reserve(static_cast<std::size_t>(count));
  for (int face = 0; face < count; ++face) {
    Triangle triangle{corners_of(vertices_mm_, faces_, face), face, Vec3::Zero(), 0.0};
    const auto& [a, b, c] = triangle.corners_mm;
    triangle.centre_mm = (a + b + c) / 3.0;
    for (const Vec3& corner : triangle.corners_mm)
      triangle.radius_mm = std::max(triangle.radius_mm, (corner - triangle.centre_mm).norm());
    triangles_.push_back(triangle);
  }
  if (count > 0) add_box(0, count);
}

void SurfaceTree::add_box(int first, int count) {
  const auto begin = triangles_.begin() + first, end = begin + count;
  const std::size_t own = boxes_.size();
  Box box{begin->corners_mm[0], begin->corners_mm[0], first, count, 0};
  for (auto triangle = begin; triangle != end; ++triangle)
    for (const Vec3& corner : triangle->corners_mm) {
      box.low_mm = box.low_mm.cwiseMin(corner);
      box.high_mm = box.high_mm.cwiseMax(corner);
    }
  boxes_.push_back(box);
  if (count <= kTrianglesInLeaf) return;
  if (std::all_of(begin + 1, end,
                  [&](const Triangle& t) { return t.corners_mm == begin->corners_mm; })) {
    std::sort(begin, end, [](const Triangle& a, const Triangle& b) { return a.face < b.face; });
    boxes_[own].same = true;
    return;
  }
  int axis = 0;
  (box.high_mm - box.low_mm).maxCoeff(&axis);
  const int half = count / 2;
  std::nth_element(begin, begin + half, end, [axis](const Triangle& a, const Triangle& b) {
    return a.centre_mm[axis] < b.centre_mm[axis];
  });
  add_box(first, half);
  boxes_[own].right = static_cast<int>(boxes_.size());
  add_box(first + half, count - half);
}

/// Depth first, the nearer half first: `bound(box)` is the least that faces in a box can reach, `leaf(box)` looks at all of
/// them and returns the best so far.
template <class Bound, class Leaf>
void SurfaceTree::descend(double best, const Bound& bound, const Leaf& leaf) const {
  struct Waiting {
    int box;
    double bound;
  };
  const auto waiting_at = [&](int i) {
    return Waiting{i, bound(boxes_[static_cast<std::size_t>(i)])};
  };
  std::array<Waiting, kDeepest> waiting;
  std::size_t count = 0;
  if (!boxes_.empty()) waiting[count++] = waiting_at(0);
  while (count > 0) {
    const Waiting next = waiting[--count];
    if (next.bound > best) continue;
    const Box& box = boxes_[static_cast<std::size_t>(next.box)];
    if (box.right == 0) {
      best = leaf(box);
      continue;
    }
    Waiting near = waiting_at(next.box + 1), far = waiting_at(box.right);
    if (far.bound < near.bound) std::swap(near, far);
    waiting[count++] = far;
    waiting[count++] = near;
  }
}

template <class Counts>
void SurfaceTree::search(const Vec3& point_mm, const Counts& counts, TreePoint& nearest) const {
  const auto bound = [&](const Box& box) {
    return squared_distance(box.low_mm, box.high_mm, point_mm);
  };
  const auto leaf = [&](const Box& box) {
    for (int i = box.first; i < box.first + box.count; ++i) {
      const Triangle& triangle = triangles_[static_cast<std::size_t>(i)];
      const double reach_mm = nearest.distance_mm + triangle.radius_mm;
      const bool reached = (point_mm - triangle.centre_mm).squaredNorm() <= reach_mm * reach_mm;
      const bool tried = reached && counts(triangle.face);
      if (tried) try_triangle(point_mm, triangle.corners_mm, triangle.face, nearest);
      if (box.same && (tried || !reached)) break;
    }
    return nearest.distance_mm * nearest.distance_mm;
  };
  descend(nearest.distance_mm * nearest.distance_mm, bound, leaf);
}

TreePoint SurfaceTree::nearest(const Vec3& point_mm, double limit_mm, int hint) const {
  TreePoint nearest;
  nearest.distance_mm = limit_mm;
  if (hint >= 0) try_triangle(point_mm, corners_of(vertices_mm_, faces_, hint), hint, nearest);
  search(
      point_mm, [](int) { return true; }, nearest);
  return nearest;
}

TreePoint SurfaceTree::nearest_within(const Vec3& point_mm, double limit_mm,
                                      const std::function<bool(int)>& counts) const {
  TreePoint nearest;
  nearest.distance_mm = limit_mm;
  search(point_mm, counts, nearest);
  return nearest;
}

double SurfaceTree::distance_mm(const Vec3& point_mm, int face) const {
  TreePoint nearest;
  if (face >= 0) try_triangle(point_mm, corners_of(vertices_mm_, faces_, face), face, nearest);
  return nearest.distance_mm;
}

TreePoint SurfaceTree::first_hit(const Vec3& from_mm, const Vec3& direction, double limit_mm,
                                 const std::function<bool(int)>& counts) const {
  TreePoint hit;
  hit.distance_mm = limit_mm;
  const auto bound = [&](const Box& box) {
    return entry_mm(box.low_mm, box.high_mm, from_mm, direction);
  };
  const auto leaf = [&](const Box& box) {
    for (int i = box.first; i < box.first + box.count; ++i) {
      const auto& [corners_mm, face, centre_mm, radius_mm] =
          triangles_[static_cast<std::size_t>(i)];
      if (!counts(face)) continue;
      const Vec3 ab = corners_mm[1] - corners_mm[0], ac = corners_mm[2] - corners_mm[0];
      // Moeller and Trumbore 1997.
      const Vec3 p = direction.cross(ac), s = from_mm - corners_mm[0], q = s.cross(ab);
      const double determinant = ab.dot(p);
      if (determinant == 0.0) continue;
      const double u = s.dot(p) / determinant, v = direction.dot(q) / determinant;
      const double away = ac.dot(q) / determinant;
      if (!(u >= 0.0 && v >= 0.0 && u + v <= 1.0 && away > 0.0)) continue;
      if (is_nearer(away, face, hit))
        hit = {face, {1.0 - u - v, u, v}, from_mm + away * direction, away};
    }
    return hit.distance_mm;
  };
  descend(limit_mm, bound, leaf);
  return hit;
}

std::vector<TreePoint> nearest_to_each(const SurfaceTree& surface, const Points& at_mm,
                                       const std::function<bool()>& cancelled) {
  constexpr Eigen::Index kLooked = 64;
  std::vector<TreePoint> nearest;
  nearest.reserve(static_cast<std::size_t>(at_mm.rows()));
  for (Eigen::Index i = 0; i < at_mm.rows(); ++i) {
    if (i % kLooked == 0 && cancelled && cancelled()) break;
    nearest.push_back(surface.nearest(at_mm.row(i).transpose()));
  }
  return nearest;
}

SurfaceEdge::SurfaceEdge(const Faces& faces)
    : faces_(faces),
      edges_(static_cast<std::size_t>(faces.rows())),
      vertices_(static_cast<std::size_t>(faces.size() > 0 ? faces.maxCoeff() + 1 : 0)) {
  std::map<std::pair<int, int>, int> uses;
  const auto edge = [&](Eigen::Index f, int opposite) {
    return std::minmax({faces(f, (opposite + 1) % 3), faces(f, (opposite + 2) % 3)});
  };
  for (Eigen::Index f = 0; f < faces.rows(); ++f)
    for (int k = 0; k < 3; ++k) ++uses[edge(f, k)];
  for (Eigen::Index f = 0; f < faces.rows(); ++f)
    for (int k = 0; k < 3; ++k) {
      const auto ends = edge(f, k);
      if (uses[ends] != 1) continue;
      edges_[static_cast<std::size_t>(f)][static_cast<std::size_t>(k)] = true;
      vertices_[static_cast<std::size_t>(ends.first)] = true;
      vertices_[static_cast<std::size_t>(ends.second)] = true;
    }
}

bool SurfaceEdge::holds(const TreePoint& at) const {
  for (int k = 0; k < 3; ++k) {
    if (at.weights[k] <= 0.0 &&
        edges_[static_cast<std::size_t>(at.face)][static_cast<std::size_t>(k)])
      return true;
    if (at.weights[k] >= 1.0 && vertices_[static_cast<std::size_t>(faces_(at.face, k))])
      return true;
  }
  return false;
}

}  // namespace coapt
