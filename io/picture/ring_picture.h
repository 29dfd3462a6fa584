// Rings drawn beside each other: from above and from the side.
#pragma once

#include <string>
#include <vector>

#include "core/repair/plan.h"

namespace coapt {

struct DrawnRing {
  std::string label;
  Points contour_mm;  ///< as ring_contour_mm()
};

/// The first is the subject, in a colour; the others are thin and grey, told apart by their dashes. Seen from the atrium, anterior above;
/// and from behind, atrium above. One scale for both views, with a bar of 10 mm.
std::string ring_picture_svg(const std::vector<DrawnRing>& rings);

/// The designed shape of that size and the generic flat shapes of the same width.
std::vector<DrawnRing> beside_generic(const DesignedShape& shape, double size_mm);

}  // namespace coapt
