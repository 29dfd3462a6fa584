// The image of the regurgitant orifice: what the atrial view shows open inside the annulus (thesis
// 4.2.1), for pictures, and to compare with: what is reported is the exact area (exact_orifice.h).
//
// The annulus polygon, projected on its plane of best fit, is drawn white into 800 x 600 pixels and
// every leaflet face black over it; connected white regions are orifices. A pixel is worth the
// polygon's area over its number of pixels (equations 4.1 and 4.2). Regions are 4-connected, so
// that tissue is 8-connected: a leaflet one pixel thin, drawn diagonally, still parts two orifices.
// Accuracy: a region's error is that of sampling at pixel centres, well below its perimeter times
// half a pixel (0.03 mm on a human valve). Limits: one view direction; a gap hidden behind tissue
// is not seen.
#pragma once

#include <vector>

#include "core/metrics/annulus.h"

namespace coapt {

/// One connected opening of the atrial view.
struct Orifice {
  double area_mm2 = 0.0;
  Vec3 centroid_mm = Vec3::Zero();  ///< on the annular plane
  Segment segment = Segment::A2;    ///< of the leaflet nearest to the centroid in that view
};

/// Pixels first..last of one row that belong to one orifice.
struct PixelRun {
  int row = 0, first = 0, last = 0;
  int orifice = 0;  ///< index into OrificeView::orifices
};

/// Pixels; the thesis's by default.
struct ImageSize {
  int width = 800, height = 600;
};

/// The atrial view: columns run posteromedially, rows posteriorly.
struct OrificeView {
  int width = 800, height = 600;
  AnnulusFrame plane;
  Vec2 centre_mm = Vec2::Zero();  ///< plane coordinates of the middle of the image
  double mm_per_pixel = 0.0;
  double pixel_area_mm2 = 0.0;    ///< equation 4.2
  std::vector<Orifice> orifices;  ///< largest first
  std::vector<PixelRun> runs;     ///< top to bottom, left to right
};

/// Pixel coordinates (continuous, (0, 0) the top left corner) of a point in plane coordinates, and
/// back.
Vec2 to_pixels(const OrificeView& view, const Vec2& coordinates_mm);
Vec2 from_pixels(const OrificeView& view, const Vec2& pixels);

/// @param closed_mm |V| x 3, finite.
/// @param half_thickness_mm by which the leaflets' mid-surfaces are grown in the view, >= 0.
OrificeView view_orifices(const Valve& valve, const Points& closed_mm, double half_thickness_mm,
                          const ImageSize& size = {});

}  // namespace coapt
