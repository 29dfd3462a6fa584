// A search over all faces in the plane of (around, height).
#include "core/valve/leaflet_point.h"

#include <algorithm>
#include <array>
#include <limits>

#include "core/valve/turns.h"

namespace coapt {
namespace {

/// Weights of the point of triangle (a, b, c) nearest to the origin, in the plane.
std::array<double, 3> nearest_weights(const Vec2& a, const Vec2& b, const Vec2& c) {
  const auto cross = [](const Vec2& u, const Vec2& v) { return u.x() * v.y() - u.y() * v.x(); };
  const double twice_area = cross(b - a, c - a);
  if (twice_area != 0.0) {
    const std::array<double, 3> inside = {cross(b, c) / twice_area, cross(c, a) / twice_area,
                                          cross(a, b) / twice_area};
    if (*std::min_element(inside.begin(), inside.end()) >= 0.0)
      return {std::min(1.0, inside[0]), std::min(1.0, inside[1]), std::min(1.0, inside[2])};
  }
  const std::array<Vec2, 3> corner = {a, b, c};
  std::array<double, 3> best{};
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec2& p = corner[k];
    const Vec2 side = corner[(k + 1) % 3] - p;
    const double length2 = side.squaredNorm();
    const double t = length2 > 0.0 ? std::clamp(-p.dot(side) / length2, 0.0, 1.0) : 0.0;
    const double distance2 = (p + t * side).squaredNorm();
    if (distance2 >= nearest) continue;
    nearest = distance2;
    best = {};
    best[k] = 1.0 - t;
    best[(k + 1) % 3] = t;
  }
  return best;
}

}  // namespace

double around(const LeafletPoint& point) {
  switch (point.leaflet) {
    case Leaflet::Anterior:
      return turn_fraction(0.5 - 0.5 * point.along);
    case Leaflet::Posterior:
      return turn_fraction(0.5 + 0.5 * point.along);
  }
  return 0.0;
}

Insertion locate(const Valve& valve, const LeafletCoordinates& coordinates,
                 const LeafletPoint& point) {
  const double target = around(point);
  Insertion best;
  double nearest = std::numeric_limits<double>::infinity();
  for (int f = 0; f < valve.faces.rows(); ++f) {
    // Corners relative to the target; the face is kept whole where `around` jumps.
    std::array<Vec2, 3> corner;
    for (int k = 0; k < 3; ++k) {
      const int vertex = valve.faces(f, k);
      const double from_first = coordinates.around[vertex] - coordinates.around[valve.faces(f, 0)];
      const double across = k == 0 ? wrapped(coordinates.around[vertex] - target)
                                   : corner[0].x() + wrapped(from_first);
      corner[k] = {across, coordinates.height[vertex] - point.height};
    }
    // Not even the box about it is as near.
    const Vec2 low = corner[0].cwiseMin(corner[1]).cwiseMin(corner[2]),
               high = corner[0].cwiseMax(corner[1]).cwiseMax(corner[2]);
    if (low.cwiseMax(-high).cwiseMax(0.0).squaredNorm() > nearest) continue;
    const std::array<double, 3> weights = nearest_weights(corner[0], corner[1], corner[2]);
    const double distance2 =
        (weights[0] * corner[0] + weights[1] * corner[1] + weights[2] * corner[2]).squaredNorm();
    if (distance2 >= nearest) continue;
    nearest = distance2;
    best = {f, weights};
  }
  return best;
}

Vec3 rest_position_mm(const Valve& valve, const LeafletCoordinates& coordinates,
                      const LeafletPoint& point) {
  return position(locate(valve, coordinates, point), valve.faces, valve.rest_mm);
}

LeafletPoint leaflet_point(const Valve& valve, const LeafletCoordinates& coordinates,
                           const Insertion& insertion) {
  const int first = valve.faces(insertion.face, 0);
  double place = coordinates.around[first], height = 0.0;
  for (int k = 0; k < 3; ++k) {
    const int vertex = valve.faces(insertion.face, k);
    const double weight = insertion.weights[k];
    place += weight * wrapped(coordinates.around[vertex] - coordinates.around[first]);
    height += weight * coordinates.height[vertex];
  }
  return leaflet_point(place, height);
}

double middle_along(const Valve& valve, const LeafletCoordinates& coordinates, Segment segment) {
  double sum = 0.0;
  int faces = 0;
  for (std::size_t f = 0; f < valve.segments.size(); ++f) {
    if (valve.segments[f] != segment) continue;
    constexpr double kThird = 1.0 / 3.0;
    const Insertion middle{static_cast<int>(f), {kThird, kThird, kThird}};
    sum += leaflet_point(valve, coordinates, middle).along;
    ++faces;
  }
  return sum / faces;
}

LeafletPoint leaflet_point(double around, double height) {
  const double place = turn_fraction(around);
  if (place < 0.5) return {Leaflet::Anterior, 1.0 - 2.0 * place, height};
  return {Leaflet::Posterior, 2.0 * place - 1.0, height};
}

}  // namespace coapt
