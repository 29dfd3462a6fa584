// Leaflet faces are painted far to near along the annular normal with smoothly interpolated light,
// darker with depth, so that the line of coaptation reads as the groove it is; behind them lies a
// rim of half the leaflets' thickness, the one that counts in the orifice.
#pragma once

#include <array>
#include <vector>

#include "core/metrics/annulus.h"
#include "io/picture/canvas.h"

namespace coapt {

/// From plane coordinates to canvas pixels.
struct Mapping {
  Vec2 centre_mm, centre_px;
  double pixels_per_mm;
  Vec2 operator()(const Vec2& point_mm) const {
    const Vec2 offset = pixels_per_mm * (point_mm - centre_mm);
    return {centre_px.x() + offset.x(), centre_px.y() - offset.y()};
  }
};

struct PaintedFace {
  double depth_mm = 0.0;
  std::array<Vec2, 3> corners;
  std::array<Colour, 3> colours;
};

/// Far to near.
std::vector<PaintedFace> painted_faces(const Valve& valve, const Points& closed_mm,
                                       const AnnulusFrame& plane, const Mapping& map);

void paint_rims(const Canvas& canvas, const std::vector<PaintedFace>& faces, double thickness_px);

void paint_leaflets(const Canvas& canvas, const std::vector<PaintedFace>& faces);

}  // namespace coapt
