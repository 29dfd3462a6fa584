#include "core/metrics/surface.h"

#include <algorithm>
#include <limits>

#include "core/closure/contact.h"

namespace coapt {
namespace {

constexpr int kTrianglesInLeaf = 8;
constexpr std::size_t kDeepest = 64;  // halves of 2^31 triangles are 31 deep

/// Adds the box around triangles [first, first + count) of `surface`, and the boxes inside it.
void add_box(TriangleSet& surface, int first, int count) {
  const auto begin = surface.triangles.begin() + first, end = begin + count;
  const std::size_t own = surface.boxes.size();
  SurfaceBox box{(*begin)[0], (*begin)[0], first, count, 0};
  for (auto triangle = begin; triangle != end; ++triangle)
    for (const Vec3& corner : *triangle) {
      box.low_mm = box.low_mm.cwiseMin(corner);
      box.high_mm = box.high_mm.cwiseMax(corner);
    }
  surface.boxes.push_back(box);
  if (count <= kTrianglesInLeaf) return;
  int axis = 0;
  (box.high_mm - box.low_mm).maxCoeff(&axis);
  const int half = count / 2;
  std::nth_element(
      begin, begin + half, end, [&](const SurfaceTriangle& a, const SurfaceTriangle& b) {
        return a[0][axis] + a[1][axis] + a[2][axis] < b[0][axis] + b[1][axis] + b[2][axis];
      });
  add_box(surface, first, half);
  surface.boxes[own].right = static_cast<int>(surface.boxes.size());
  add_box(surface, first + half, count - half);
}

double squared_distance(const SurfaceBox& box, const Vec3& point) {
  double sum = 0.0;
  for (int k = 0; k < 3; ++k) {
    const double beside =
        std::max(std::max(box.low_mm[k] - point[k], point[k] - box.high_mm[k]), 0.0);
    sum += beside * beside;
  }
  return sum;
}

Sphere sphere_around(const SurfaceTriangle& triangle) {
  Sphere sphere{(triangle[0] + triangle[1] + triangle[2]) / 3.0, 0.0};
  for (const Vec3& corner : triangle)
    sphere.radius_mm = std::max(sphere.radius_mm, (corner - sphere.centre_mm).norm());
  return sphere;
}

void try_triangle(const TriangleSet& surface, int triangle, const Vec3& point,
                  SurfacePoint& nearest) {
  const auto& [a, b, c] = surface.triangles[static_cast<std::size_t>(triangle)];
  const Vec3 weights = closest_point_weights(point, a, b, c);
  const Vec3 closest = weights[0] * a + weights[1] * b + weights[2] * c;
  const double distance_mm = (point - closest).norm();
  if (distance_mm < nearest.distance_mm) nearest = {closest, distance_mm, triangle};
}

void try_leaf(const TriangleSet& surface, const SurfaceBox& leaf, const Vec3& point,
              SurfacePoint& nearest) {
  for (int i = leaf.first; i < leaf.first + leaf.count; ++i) {
    const Sphere& sphere = surface.spheres[static_cast<std::size_t>(i)];
    const double reach_mm = nearest.distance_mm + sphere.radius_mm;
    if ((point - sphere.centre_mm).squaredNorm() < reach_mm * reach_mm)
      try_triangle(surface, i, point, nearest);
  }
}

}  // namespace

TriangleSet make_surface(std::vector<SurfaceTriangle> triangles) {
  TriangleSet surface{std::move(triangles), {}, {}};
  if (surface.triangles.empty()) return surface;
  add_box(surface, 0, static_cast<int>(surface.triangles.size()));
  surface.spheres.reserve(surface.triangles.size());
  for (const SurfaceTriangle& triangle : surface.triangles)
    surface.spheres.push_back(sphere_around(triangle));
  return surface;
}

SurfacePoint nearest_within(const TriangleSet& surface, const Vec3& point, double limit_mm,
                            int hint) {
  SurfacePoint nearest{point, limit_mm, -1};
  if (hint >= 0) try_triangle(surface, hint, point, nearest);
  struct Waiting {
    int box;
    double squared;
  };
  std::array<Waiting, kDeepest> waiting;
  std::size_t count = 0;
  if (!surface.boxes.empty()) waiting[count++] = {0, 0.0};
  while (count > 0) {
    const Waiting next = waiting[--count];
    if (next.squared >= nearest.distance_mm * nearest.distance_mm) continue;
    const SurfaceBox& box = surface.boxes[static_cast<std::size_t>(next.box)];
    if (box.right == 0) {
      try_leaf(surface, box, point, nearest);
      continue;
    }
    Waiting near{next.box + 1, 0.0}, far{box.right, 0.0};
    near.squared = squared_distance(surface.boxes[static_cast<std::size_t>(near.box)], point);
    far.squared = squared_distance(surface.boxes[static_cast<std::size_t>(far.box)], point);
    if (far.squared < near.squared) std::swap(near, far);
    waiting[count++] = far;
    waiting[count++] = near;
  }
  return nearest;
}

double distance_to(const TriangleSet& surface, const Vec3& point, int triangle) {
  SurfacePoint nearest{point, std::numeric_limits<double>::infinity(), -1};
  if (triangle >= 0) try_triangle(surface, triangle, point, nearest);
  return nearest.distance_mm;
}

double distance_within(const TriangleSet& surface, const Vec3& point, double limit_mm) {
  return nearest_within(surface, point, limit_mm).distance_mm;
}

Vec3 nearest_point(const TriangleSet& surface, const Vec3& point) {
  return nearest_within(surface, point, std::numeric_limits<double>::infinity()).point_mm;
}

}  // namespace coapt
