// The dimensions of the annulus under pressure.
#pragma once

#include <vector>

#include "core/valve/annulus_frame.h"

namespace coapt {

/// Projected annulus, |A| points, counter-clockwise.
std::vector<Vec2> annulus_polygon(const Valve& valve, const AnnulusFrame& plane);

/// Shoelace formula (thesis equation 4.1), positive when counter-clockwise.
double polygon_area(const std::vector<Vec2>& polygon);

struct AnnulusMeasure {
  /// ap_diameter_mm() and transverse_diameter_mm(); of a valve that is not mitral its extents along y and x.
  double ap_mm = 0.0, al_pm_mm = 0.0;
  double circumference_mm = 0.0;
  double area_mm2 = 0.0;          ///< projected on that plane
  double saddle_height_mm = 0.0;  ///< extent along that plane's normal
};

AnnulusMeasure measure_annulus(const Valve& valve);

}  // namespace coapt
