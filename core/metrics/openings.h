// What tissue in a plane leaves open of what a closed outline surrounds: connected regions with
// their area, place and contours.
//
// Tissue covers what its outlines wind round, and with a radius whatever is within that of its
// outlines and lines (its Minkowski sum with a disc). Inside the outline is what it winds round,
// where it crosses itself also. Coordinates are rounded to the grid (plane_grid.h).
#pragma once

#include <optional>
#include <vector>

#include "core/metrics/annulus.h"

namespace coapt {

/// Of any number of leaves that lie over each other.
struct FlatTissue {
  std::vector<std::vector<Vec2>> outlines_mm;  ///< closed, wind round what is covered
  std::vector<std::vector<Vec2>> lines_mm;     ///< open, two points or more, cover nothing bare
};

/// A region's outer boundary with the boundaries of its islands.
struct Opening {
  double area_mm2 = 0.0;
  Vec2 moment_mm3 = Vec2::Zero();              ///< centroid times area
  std::vector<std::vector<Vec2>> contours_mm;  ///< closed, outer first
};

/// Largest first; nullopt where the union failed.
struct Openings {
  std::optional<std::vector<Opening>> bare;   ///< of the tissue's outlines alone
  std::optional<std::vector<Opening>> grown;  ///< of tissue grown by the radius
};

/// By clipped_openings(), in WebAssembly by swept_openings().
/// @param outline_mm closed, n points, either direction.
/// @param radius_mm >= 0; at 0 lines cover nothing.
Openings openings_of(const std::vector<Vec2>& outline_mm, const FlatTissue& tissue,
                     double radius_mm);

/// NaN where the union failed.
double total_mm2(const std::optional<std::vector<Opening>>& openings);

}  // namespace coapt
