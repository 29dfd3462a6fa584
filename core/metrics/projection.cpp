#include "core/metrics/projection.h"

#include <algorithm>
#include <limits>

namespace coapt {
namespace {

double squared_distance_to_segment(const Vec2& point, const Vec2& a, const Vec2& b) {
  const Vec2 along = b - a;
  const double length_squared = along.squaredNorm();
  const double t =
      length_squared > 0.0 ? std::clamp((point - a).dot(along) / length_squared, 0.0, 1.0) : 0.0;
  return (point - a - t * along).squaredNorm();
}

double squared_distance_to_triangle(const Vec2& point, const Triangle& triangle) {
  double nearest = std::numeric_limits<double>::infinity();
  int left = 0, right = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec2 &a = triangle[i], &b = triangle[(i + 1) % 3];
    const double turn = (b - a).x() * (point - a).y() - (b - a).y() * (point - a).x();
    ++(turn > 0.0 ? left : right);
    nearest = std::min(nearest, squared_distance_to_segment(point, a, b));
  }
  return left == 3 || right == 3 ? 0.0 : nearest;
}

}  // namespace

Projection project_valve(const Valve& valve, const Points& closed_mm, const AnnulusFrame& plane) {
  Projection projection{plane, annulus_polygon(valve, plane), {}};
  std::vector<Vec2> vertices(closed_mm.rows());
  for (std::size_t i = 0; i < vertices.size(); ++i)
    vertices[i] = project(plane, closed_mm.row(i).transpose());
  projection.faces.reserve(valve.faces.rows());
  for (Index f = 0; f < valve.faces.rows(); ++f) {
    const auto corner = [&](int k) { return vertices[valve.faces(f, k)]; };
    projection.faces.push_back({corner(0), corner(1), corner(2)});
  }
  return projection;
}

Segment nearest_segment(const Valve& valve, const Projection& projection, const Vec2& point_mm) {
  double nearest = std::numeric_limits<double>::infinity();
  Segment segment = Segment::A2;
  for (std::size_t f = 0; f < projection.faces.size(); ++f) {
    const auto& [a, b, c] = projection.faces[f];
    const Vec2 below = a.cwiseMin(b).cwiseMin(c) - point_mm;
    const Vec2 above = point_mm - a.cwiseMax(b).cwiseMax(c);
    if (below.cwiseMax(above).cwiseMax(0.0).squaredNorm() >= nearest)
      continue;  // its box is farther
    const double distance = squared_distance_to_triangle(point_mm, projection.faces[f]);
    if (distance < nearest) {
      nearest = distance;
      if (is_mitral(valve)) segment = valve.segments[f];
    }
  }
  return segment;
}

}  // namespace coapt
