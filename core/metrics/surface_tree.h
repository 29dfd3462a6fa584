// Nearest points of a triangle mesh through a tree of boxes. Unlike surface.h it tells the face and its barycentric weights
// by the mesh's own numbers, can leave faces out, and names the face of the smallest number where several are as near.
#pragma once

#include <array>
#include <functional>
#include <limits>
#include <vector>

#include "core/valve/types.h"

namespace coapt {

struct TreePoint {
  int face = -1;                ///< -1: there is none
  Vec3 weights = Vec3::Zero();  ///< barycentric, on the face's corners
  Vec3 point_mm = Vec3::Zero();
  double distance_mm = std::numeric_limits<double>::infinity();
};

class SurfaceTree {
 public:
  /// At least one face. Indices must be in range.
  SurfaceTree(Points vertices_mm, Faces faces);

  /// Where several faces are as near, the one with the smallest number.
  TreePoint nearest(const Vec3& point_mm) const;

  /// The nearest of the faces that `counts` says yes to, nearer than `limit_mm`.
  TreePoint nearest_within(const Vec3& point_mm, double limit_mm,
                           const std::function<bool(int)>& counts) const;

  /// Where a ray first meets a face that `counts` says yes to, nearer than `limit_mm`; faces that it runs along do not count.
  /// @param direction of length 1
  TreePoint first_hit(const Vec3& from_mm, const Vec3& direction, double limit_mm,
                      const std::function<bool(int)>& counts) const;

  const Points& vertices_mm() const { return vertices_mm_; }
  const Faces& faces() const { return faces_; }

 private:
  /// A box around faces order_[first, last); its halves are the nodes `left` and `left` + 1.
  struct Node {
    Eigen::AlignedBox3d box;
    int first = 0, last = 0, left = -1;
  };
  void split(int node);
  template <class Counts>
  TreePoint search(const Vec3& point_mm, double limit_mm, const Counts& counts) const;

  Points vertices_mm_, centres_mm_;
  Faces faces_;
  std::vector<int> order_;
  std::vector<Node> nodes_;
};

/// The boundary of a surface: the edges that one face alone has, and their ends.
class SurfaceEdge {
 public:
  explicit SurfaceEdge(const Faces& faces);
  bool holds(const TreePoint& at) const;

 private:
  Faces faces_;
  std::vector<std::array<bool, 3>> edges_;  ///< [face][corner opposite to it]
  std::vector<bool> vertices_;
};

}  // namespace coapt
