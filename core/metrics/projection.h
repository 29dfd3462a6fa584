// A closed valve seen along one direction: what every measure of the orifice starts from.
#pragma once

#include <vector>

#include "core/metrics/annulus.h"
#include "core/metrics/raster.h"

namespace coapt {

/// All in the coordinates of `plane`, in millimetres; seen from the side its normal points to.
struct Projection {
  AnnulusFrame plane;
  std::vector<Vec2> annulus;    ///< as annulus_polygon
  std::vector<Triangle> faces;  ///< as Valve::faces; degenerate where a face is seen edge-on
};

/// @param closed_mm |V| x 3.
Projection project_valve(const Valve& valve, const Points& closed_mm, const AnnulusFrame& plane);

/// Of the face nearest to `point_mm` in that view.
Segment nearest_segment(const Valve& valve, const Projection& projection, const Vec2& point_mm);

}  // namespace coapt
