// What lines of tissue leave free of an outline in a plane.
#pragma once

#include <vector>

#include "core/metrics/annulus.h"

namespace coapt {

/// Area within `outline` that is farther than `half_thickness_mm` from every line of `tissue`: exact as the orifice is
/// (exact_orifice.h). @param outline closed, n points, either direction. @param tissue open lines, each of at least two
/// points, within 1 m. NaN if the union fails.
double free_area_mm2(const std::vector<Vec2>& outline, const std::vector<std::vector<Vec2>>& tissue,
                     double half_thickness_mm);

}  // namespace coapt
