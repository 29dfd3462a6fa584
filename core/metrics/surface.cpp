#include "core/metrics/surface.h"

#include <algorithm>
#include <limits>

#include "core/closure/contact.h"

namespace coapt {

void add_triangle(Surface& surface, const std::array<Vec3, 3>& triangle) {
  const Vec3 centre = (triangle[0] + triangle[1] + triangle[2]) / 3.0;
  double radius = 0.0;
  for (const Vec3& corner : triangle) radius = std::max(radius, (corner - centre).norm());
  surface.triangles.push_back(triangle);
  surface.centres.push_back(centre);
  surface.radii.push_back(radius);
}

namespace {

struct Nearest {
  Vec3 point = Vec3::Zero();
  double distance = 0.0;
};

Nearest nearest_within(const Surface& surface, const Vec3& point, double limit) {
  Nearest nearest{point, limit};
  for (std::size_t i = 0; i < surface.triangles.size(); ++i) {
    const double reach = nearest.distance + surface.radii[i];
    if ((point - surface.centres[i]).squaredNorm() >= reach * reach) continue;
    const auto& [a, b, c] = surface.triangles[i];
    const Vec3 weights = closest_point_weights(point, a, b, c);
    const Vec3 closest = weights[0] * a + weights[1] * b + weights[2] * c;
    const double distance = (point - closest).norm();
    if (distance < nearest.distance) nearest = {closest, distance};
  }
  return nearest;
}

}  // namespace

double distance_within(const Surface& surface, const Vec3& point, double limit) {
  return nearest_within(surface, point, limit).distance;
}

Vec3 nearest_point(const Surface& surface, const Vec3& point) {
  return nearest_within(surface, point, std::numeric_limits<double>::infinity()).point;
}

}  // namespace coapt
