// A measured annulus and its papillary tips, checked and put into the valve's frame.
#pragma once

#include "core/valve/contour.h"

namespace coapt {

/// Errors at /annulus_mm and /tips_mm: points that are all the same, other units, a contour without
/// width, more than 100 tips, tips in or near the annulus plane, far away, or all on one side.
/// @pre 12 or more finite points and 2 or more finite tips
Expected<MeasuredSkeleton> measured_skeleton(const Points& annulus_mm, const Points& tips_mm);

}  // namespace coapt
