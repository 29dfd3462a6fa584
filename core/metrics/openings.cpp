#include "core/metrics/openings.h"

#include <limits>

#include "core/metrics/openings_clipper.h"
#include "core/metrics/openings_sweep.h"

namespace coapt {

Openings openings_of(const std::vector<Vec2>& outline_mm, const FlatTissue& tissue,
                     double radius_mm) {
#ifdef __wasm__  // no library for it there: core/metrics/openings_clipper.cpp is left out
  return swept_openings(outline_mm, tissue, radius_mm);
#else
  return clipped_openings(outline_mm, tissue, radius_mm);
#endif
}

double total_mm2(const std::optional<std::vector<Opening>>& openings) {
  if (!openings) return std::numeric_limits<double>::quiet_NaN();
  double total = 0.0;
  for (const Opening& opening : *openings) total += opening.area_mm2;
  return total;
}

}  // namespace coapt
