// A closed contour without the corners that nobody sees when it is drawn.
#pragma once

#include <vector>

#include "core/metrics/annulus.h"

namespace coapt {

/// Drops corners within `distance_mm` of their neighbour or of the line through both neighbours,
/// one by one (as CleanPolygon of Clipper 6.4 does); empty if fewer than three are left. A corner
/// is judged by those still there: of many close together, round a gentle bend, all can go.
std::vector<Vec2> clean_contour(const std::vector<Vec2>& contour_mm, double distance_mm);

}  // namespace coapt
