#include "core/metrics/surface_tree.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

#include "core/closure/contact.h"

namespace coapt {
namespace {

constexpr int kLeafFaces = 4;

/// Where a ray enters a box; infinity where it misses.
double entry_mm(const Eigen::AlignedBox3d& box, const Vec3& from_mm, const Vec3& direction) {
  double enters = 0.0, leaves = std::numeric_limits<double>::infinity();
  for (int k = 0; k < 3; ++k) {
    if (direction[k] == 0.0) {
      if (from_mm[k] < box.min()[k] || from_mm[k] > box.max()[k]) return leaves;
      continue;
    }
    double near = (box.min()[k] - from_mm[k]) / direction[k];
    double far = (box.max()[k] - from_mm[k]) / direction[k];
    if (near > far) std::swap(near, far);
    enters = std::max(enters, near);
    leaves = std::min(leaves, far);
  }
  return enters <= leaves ? enters : std::numeric_limits<double>::infinity();
}

}  // namespace

SurfaceTree::SurfaceTree(Points vertices_mm, Faces faces)
    : vertices_mm_(std::move(vertices_mm)), faces_(std::move(faces)) {
  assert(faces_.rows() > 0);
  centres_mm_.resize(faces_.rows(), 3);
  for (Eigen::Index f = 0; f < faces_.rows(); ++f)
    centres_mm_.row(f) = vertices_mm_(faces_.row(f), Eigen::all).colwise().mean();
  order_.resize(static_cast<std::size_t>(faces_.rows()));
  std::iota(order_.begin(), order_.end(), 0);
  nodes_.push_back({{}, 0, static_cast<int>(faces_.rows()), -1});
  for (std::size_t node = 0; node < nodes_.size(); ++node) split(static_cast<int>(node));
}

void SurfaceTree::split(int index) {
  Node node = nodes_[static_cast<std::size_t>(index)];
  Eigen::AlignedBox3d centres;
  const auto begin = order_.begin() + node.first, end = order_.begin() + node.last;
  for (auto face = begin; face != end; ++face) {
    centres.extend(Vec3(centres_mm_.row(*face).transpose()));
    for (const int vertex : faces_.row(*face))
      node.box.extend(Vec3(vertices_mm_.row(vertex).transpose()));
  }
  if (node.last - node.first > kLeafFaces) {
    Eigen::Index axis = 0;
    centres.sizes().maxCoeff(&axis);
    const auto middle = begin + (end - begin) / 2;
    std::nth_element(begin, middle, end, [&](int a, int b) {
      return std::pair(centres_mm_(a, axis), a) < std::pair(centres_mm_(b, axis), b);
    });
    node.left = static_cast<int>(nodes_.size());
    const int half = static_cast<int>(middle - order_.begin());
    nodes_.push_back({{}, node.first, half, -1});
    nodes_.push_back({{}, half, node.last, -1});
  }
  nodes_[static_cast<std::size_t>(index)] = node;
}

template <class Counts>
TreePoint SurfaceTree::search(const Vec3& point_mm, double limit_mm, const Counts& counts) const {
  TreePoint nearest;
  nearest.distance_mm = limit_mm;
  std::vector<std::pair<double, int>> open = {{nodes_[0].box.exteriorDistance(point_mm), 0}};
  while (!open.empty()) {
    const auto [distance, index] = open.back();
    open.pop_back();
    if (distance > nearest.distance_mm) continue;
    const Node& node = nodes_[static_cast<std::size_t>(index)];
    if (node.left >= 0) {
      std::array<std::pair<double, int>, 2> halves;
      for (int k = 0; k < 2; ++k) {
        const int half = node.left + k;
        halves[static_cast<std::size_t>(k)] = {
            nodes_[static_cast<std::size_t>(half)].box.exteriorDistance(point_mm), half};
      }
      if (halves[0].first < halves[1].first) std::swap(halves[0], halves[1]);
      open.insert(open.end(), halves.begin(), halves.end());
      continue;
    }
    for (int i = node.first; i < node.last; ++i) {
      const int face = order_[static_cast<std::size_t>(i)];
      if (!counts(face)) continue;
      const Vec3 a = vertices_mm_.row(faces_(face, 0)).transpose();
      const Vec3 b = vertices_mm_.row(faces_(face, 1)).transpose();
      const Vec3 c = vertices_mm_.row(faces_(face, 2)).transpose();
      const Vec3 weights = closest_point_weights(point_mm, a, b, c);
      const Vec3 at = weights[0] * a + weights[1] * b + weights[2] * c;
      const double away = (point_mm - at).norm();
      if (away < nearest.distance_mm ||
          (away == nearest.distance_mm && nearest.face >= 0 && face < nearest.face))
        nearest = {face, weights, at, away};
    }
  }
  return nearest;
}

TreePoint SurfaceTree::nearest(const Vec3& point_mm) const {
  return search(point_mm, std::numeric_limits<double>::infinity(), [](int) { return true; });
}

TreePoint SurfaceTree::nearest_within(const Vec3& point_mm, double limit_mm,
                                      const std::function<bool(int)>& counts) const {
  return search(point_mm, limit_mm, counts);
}

TreePoint SurfaceTree::first_hit(const Vec3& from_mm, const Vec3& direction, double limit_mm,
                                 const std::function<bool(int)>& counts) const {
  TreePoint hit;
  hit.distance_mm = limit_mm;
  std::vector<int> open = {0};
  while (!open.empty()) {
    const Node& node = nodes_[static_cast<std::size_t>(open.back())];
    open.pop_back();
    if (entry_mm(node.box, from_mm, direction) > hit.distance_mm) continue;
    if (node.left >= 0) {
      open.insert(open.end(), {node.left + 1, node.left});
      continue;
    }
    for (int i = node.first; i < node.last; ++i) {
      const int face = order_[static_cast<std::size_t>(i)];
      if (!counts(face)) continue;
      const Vec3 a = vertices_mm_.row(faces_(face, 0)).transpose();
      const Vec3 ab = vertices_mm_.row(faces_(face, 1)).transpose() - a;
      const Vec3 ac = vertices_mm_.row(faces_(face, 2)).transpose() - a;
      // Moeller and Trumbore 1997.
      const Vec3 p = direction.cross(ac), s = from_mm - a, q = s.cross(ab);
      const double determinant = ab.dot(p);
      if (determinant == 0.0) continue;
      const double u = s.dot(p) / determinant, v = direction.dot(q) / determinant;
      const double away = ac.dot(q) / determinant;
      if (!(u >= 0.0 && v >= 0.0 && u + v <= 1.0 && away > 0.0)) continue;
      if (away < hit.distance_mm || (away == hit.distance_mm && face < hit.face))
        hit = {face, {1.0 - u - v, u, v}, from_mm + away * direction, away};
    }
  }
  return hit;
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
