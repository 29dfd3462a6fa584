// The regurgitant orifice of the thesis (4.2.1): what the atrial view shows open inside the annulus. Of its tables, of estimates within
// searches, and of the area that an open valve projects; a leak is the least surface (leak.h).
//
// The annulus polygon, projected on its plane of best fit, is drawn white into an image and every leaflet face black over it; a pixel
// is worth the polygon's area over its number of pixels (equations 4.1 and 4.2). Accuracy: that of sampling at pixel centres, well below
// the outline's length times half a pixel (0.03 mm on a human valve at 800 x 600). Limits: one direction of view; a gap hidden behind tissue
// is not seen.
#pragma once

#include "core/valve/valve.h"

namespace coapt {

/// Pixels; the thesis's by default.
struct ImageSize {
  int width = 800, height = 600;
};

/// @param points_mm |V| x 3, finite
/// @param half_thickness_mm by which the leaflets' mid-surfaces are grown in the view, >= 0
double orifice_mm2(const Valve& valve, const Points& points_mm, double half_thickness_mm,
                   const ImageSize& size = {});

/// Leaflets with half their own thickness.
double orifice_mm2(const Valve& valve, const Points& points_mm);

}  // namespace coapt
