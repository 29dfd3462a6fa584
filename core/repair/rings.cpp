#include "core/repair/rings.h"

#include <algorithm>

#include "core/valve/contour.h"

namespace coapt {

const RingShape* find_ring(std::string_view name) {
  const auto found = std::ranges::find(kRingShapes, name, &RingShape::name);
  return found == kRingShapes.end() ? nullptr : &*found;
}

double ring_width_mm(const RingShape& ring, double size_mm) {
  return ring.transverse_factor * size_mm;
}

Points ring_contour_mm(const RingShape& ring, double size_mm) {
  const double width = ring_width_mm(ring, size_mm);
  return generic_annulus_contour(ring.ap_over_transverse * width, width,
                                 ring.saddle_over_transverse * width);
}

}  // namespace coapt
