#pragma once

#include <array>
#include <vector>

#include "core/valve/types.h"

namespace coapt {

/// Triangles with bounding spheres, to measure distances from.
struct Surface {
  std::vector<std::array<Vec3, 3>> triangles;
  std::vector<Vec3> centres;
  std::vector<double> radii;
};

void add_triangle(Surface& surface, const std::array<Vec3, 3>& triangle);

/// Distance to the surface, exact if it is less than `limit`; else `limit`.
double distance_within(const Surface& surface, const Vec3& point, double limit);

/// The surface must not be empty.
Vec3 nearest_point(const Surface& surface, const Vec3& point);

}  // namespace coapt
