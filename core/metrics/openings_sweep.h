#pragma once

#include "core/metrics/openings.h"

namespace coapt {

/// By scan lines, without a library (openings_sweep.cpp); never fails. Accuracy: within 5e-4 mm2 of
/// clipped_openings() on 120 closed valves, 3e-3 mm2 in whichever direction x points. Openings and
/// tissue narrower than 0.05 mm along x can be missed, and tissue that thin can join what it parts.
/// Takes 1 ms for 650 faces, four times as long.
Openings swept_openings(const std::vector<Vec2>& outline_mm, const FlatTissue& tissue,
                        double radius_mm);

}  // namespace coapt
