// Drawing filled shapes into a mask of pixels, exact at pixel centres.
//
// A pixel belongs to a shape if its centre does. That is unbiased: the pixels of a shape times a
// pixel's area converge to its area from both sides, and a sheet seen edge-on covers nothing, as a
// surface without thickness should. Triangles are closed sets: two that share an edge compute that
// edge with the same bits, so no centre falls between them, and covering a pixel twice does no harm
// (a top-left rule would only prevent that).
//
// Thickness is drawn as geometry: a triangle grown by a radius (its Minkowski sum with a disc) is
// convex, hence one interval per row. The result is that of an exact distance transform of the
// shape itself, not of its pixels, so it has no pixel of bias and a sheet seen edge-on gets its
// full thickness.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/valve/types.h"

namespace coapt {

/// Row 0 is the top; the centre of the pixel (column, row) lies at (column + 0.5, row + 0.5).
struct Mask {
  int width = 0, height = 0;
  std::vector<std::uint8_t> pixels;  ///< 0 or 1, row after row
};

/// Sets the pixels inside `polygon_px` (any simple polygon, by the even-odd rule) and returns how
/// many.
int mark_polygon(Mask& mask, const std::vector<Eigen::Vector2d>& polygon_px);

using Triangle = std::array<Eigen::Vector2d, 3>;

/// Clears the pixels within `radius_px` (>= 0) of the triangles, which may be degenerate or lie
/// outside.
void cover_triangles(Mask& mask, const std::vector<Triangle>& triangles_px, double radius_px);

}  // namespace coapt
