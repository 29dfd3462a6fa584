#pragma once

#include <vector>

#include "io/mesh/mesh_file.h"

namespace coapt {

/// Of a point from the nearest of the sheets' triangles; 1e300 without any.
double distance_mm(const std::vector<TriangleMesh>& sheets, const Vec3& point);

}  // namespace coapt
