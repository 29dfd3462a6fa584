#include "core/repair/ring_sizing.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/repair/limits.h"
#include "core/valve/annulus_frame.h"

namespace coapt {

double anterior_height_mm(const Valve& valve) {
  const auto at = [&](int vertex) -> Vec3 { return valve.rest_mm.row(vertex); };
  double farthest = 0.0, height = 0.0;
  for (std::size_t f = 0; f < valve.segments.size(); ++f) {
    if (valve.segments[f] != Segment::A2) continue;
    for (const int vertex : valve.faces.row(static_cast<Eigen::Index>(f))) {
      double nearest = std::numeric_limits<double>::infinity();
      for (const int hinge : valve.annulus)
        nearest = std::min(nearest, (at(vertex) - at(hinge)).norm());
      if (nearest <= farthest) continue;
      farthest = nearest;
      height = (at(vertex) - at(valve.landmarks.saddle_peak)).norm();
    }
  }
  return height;
}

double true_ring_size_mm(const Valve& valve) {
  const double by_leaflet = anterior_height_mm(valve) / kHealthyProportion;
  const double width = transverse_diameter_mm(valve);
  return by_leaflet > 0.0 ? std::min(by_leaflet, width) : width;
}

double ring_sizes_below(const Valve& before, const Valve& repaired) {
  const double size =
      std::sqrt(ap_diameter_mm(repaired) * transverse_diameter_mm(repaired) / kHealthyProportion);
  const double below = (true_ring_size_mm(before) - size) / kRingSizeStep_mm;
  return below <= 0.0 ? 0.0 : below;  // NaN if a diameter is
}

bool is_too_wide(const Valve& valve, double width_mm) {
  constexpr double kRounding = 1e-9;
  return width_mm > transverse_diameter_mm(valve) + 0.5 * kRingSizeStep_mm + kRounding;
}

}  // namespace coapt
