#include "core/metrics/scan_bounds.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/metrics/plane_grid.h"

namespace coapt {

ScanBound edge_bound(const Vec2& a_mm, const Vec2& b_mm) {
  ScanBound bound;
  bound.from_mm = from_grid(to_grid(a_mm));
  bound.to_mm = from_grid(to_grid(b_mm));
  if (bound.to_mm.x() < bound.from_mm.x()) {
    std::swap(bound.from_mm, bound.to_mm);
    bound.winding = -1;
  }
  const Vec2 along = bound.to_mm - bound.from_mm;
  if (along.x() > 0.0) bound.slope = along.y() / along.x();
  bound.first_mm = bound.from_mm.x();
  bound.last_mm = bound.to_mm.x();
  return bound;
}

ScanBound grown_bound(const Vec2& a_mm, const Vec2& b_mm, double radius_mm) {
  ScanBound bound = edge_bound(a_mm, b_mm);
  bound.cover = Cover::Grown;
  bound.radius_mm = radius_mm;
  if (bound.first_mm < bound.last_mm)
    bound.aside_mm = radius_mm * Vec2(-bound.slope, 1.0).normalized();
  bound.first_mm -= radius_mm;
  bound.last_mm += radius_mm;
  return bound;
}

double edge_at(const ScanBound& bound, double x_mm) {
  return bound.from_mm.y() + (x_mm - bound.from_mm.x()) * bound.slope;
}

double side_at(const ScanBound& bound, double x_mm, double side) {
  const Vec2 start_mm = bound.from_mm + side * bound.aside_mm;
  const Vec2 end_mm = bound.to_mm + side * bound.aside_mm;
  if (x_mm >= start_mm.x() && x_mm < end_mm.x())
    return start_mm.y() + (x_mm - start_mm.x()) * bound.slope;
  const bool is_along_y = bound.from_mm.x() == bound.to_mm.x();
  const bool is_round_end =
      is_along_y ? side * (end_mm.y() - start_mm.y()) > 0.0 : x_mm >= end_mm.x();
  const Vec2& centre_mm = is_round_end ? bound.to_mm : bound.from_mm;
  const double beside_mm = x_mm - centre_mm.x();
  const double squared_mm2 = bound.radius_mm * bound.radius_mm - beside_mm * beside_mm;
  return centre_mm.y() + side * std::sqrt(std::max(0.0, squared_mm2));
}

}  // namespace coapt
