#pragma once

#include "core/metrics/openings.h"

namespace coapt {

/// By unions of polygons, exact up to the rounding of where edges meet (Vatti's algorithm, library
/// Clipper 6.4); arcs are polygons within 1e-4 mm. Accuracy: 1e-4 mm times the contours' length at
/// worst; bare, a hundredth of that.
Openings clipped_openings(const std::vector<Vec2>& outline_mm, const FlatTissue& tissue,
                          double radius_mm);

}  // namespace coapt
