// Distances from a set of triangles: a tree of boxes over them, in its leaves spheres around each
// triangle, and inside these the exact distance.
#pragma once

#include <array>
#include <vector>

#include "core/valve/types.h"

namespace coapt {

using SurfaceTriangle = std::array<Vec3, 3>;

struct Sphere {
  Vec3 centre_mm = Vec3::Zero();
  double radius_mm = 0.0;
};

/// A box around triangles [first, first + count) and, if it has `right`, two more boxes inside: the
/// next one and `right`.
struct SurfaceBox {
  Vec3 low_mm, high_mm;
  int first = 0, count = 0;
  int right = 0;  ///< 0: a leaf of the tree
};

struct TriangleSet {
  std::vector<SurfaceTriangle> triangles;  ///< in the order of the tree
  std::vector<Sphere> spheres;             ///< around each of them
  std::vector<SurfaceBox> boxes;           ///< the root first; none without triangles
};

TriangleSet make_surface(std::vector<SurfaceTriangle> triangles);

struct SurfacePoint {
  Vec3 point_mm = Vec3::Zero();
  double distance_mm = 0.0;
  int triangle = -1;  ///< index into TriangleSet::triangles; -1: none is nearer than the limit
};

/// The point of the surface nearest to `point`, if it is nearer than `limit_mm`; else `point`
/// itself, at `limit_mm`. A triangle thought to be near, as `hint`, saves time.
SurfacePoint nearest_within(const TriangleSet& surface, const Vec3& point, double limit_mm,
                            int hint = -1);

/// Distance to one of its triangles; infinite to triangle -1.
double distance_to(const TriangleSet& surface, const Vec3& point, int triangle);

/// Distance to the surface, exact if it is less than `limit_mm`; else `limit_mm`.
double distance_within(const TriangleSet& surface, const Vec3& point, double limit_mm);

/// The surface must not be empty.
Vec3 nearest_point(const TriangleSet& surface, const Vec3& point);

}  // namespace coapt
