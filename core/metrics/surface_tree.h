// Nearest points of a triangle mesh, and where rays meet it: a tree of boxes over the faces, in its leaves spheres around each
// face, and inside these the exact distance. Of faces that are as near, the one with the smallest number counts. Faces that are
// one triangle again and again cost no more than one; of many that are nearly one, each may have to be looked at.
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
  /// Indices must be in range, vertices finite. Without faces nothing is near.
  SurfaceTree(Points vertices_mm, Faces faces);

  /// Nearer than `limit_mm`; else at that distance, without a face. A face thought to be near, as `hint`, saves time.
  TreePoint nearest(const Vec3& point_mm, double limit_mm = std::numeric_limits<double>::infinity(),
                    int hint = -1) const;

  /// The nearest of the faces that `counts` says yes to, nearer than `limit_mm`.
  TreePoint nearest_within(const Vec3& point_mm, double limit_mm,
                           const std::function<bool(int)>& counts) const;

  /// Infinite to face -1.
  double distance_mm(const Vec3& point_mm, int face) const;

  /// Where a ray first meets a face that `counts` says yes to, nearer than `limit_mm`; faces that it runs along do not count.
  /// @param direction of length 1
  TreePoint first_hit(const Vec3& from_mm, const Vec3& direction, double limit_mm,
                      const std::function<bool(int)>& counts) const;

  const Points& vertices_mm() const { return vertices_mm_; }
  const Faces& faces() const { return faces_; }

 private:
  struct Triangle {
    std::array<Vec3, 3> corners_mm;
    int face;
    Vec3 centre_mm;  ///< of a sphere around it
    double radius_mm;
  };
  /// Around triangles_[first, first + count). If it has `right`, its halves are the next box and `right`.
  struct Box {
    Vec3 low_mm, high_mm;
    int first = 0, count = 0;
    int right = 0;      ///< 0: a leaf
    bool same = false;  ///< a leaf of any size: one triangle again and again, by number
  };
  void add_box(int first, int count);
  template <class Bound, class Leaf>
  void descend(double best, const Bound& bound, const Leaf& leaf) const;
  template <class Counts>
  void search(const Vec3& point_mm, const Counts& counts, TreePoint& nearest) const;

  Points vertices_mm_;
  Faces faces_;
  std::vector<Triangle> triangles_;  ///< in the order of the tree
  std::vector<Box> boxes_;           ///< the root first
};

/// The nearest to each row, in order.
/// @param cancelled asked every 64 rows, because a row may have to look at every face of a surface that lies on itself; true
/// leaves out the rows that are left
std::vector<TreePoint> nearest_to_each(const SurfaceTree& surface, const Points& at_mm,
                                       const std::function<bool()>& cancelled = {});

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
