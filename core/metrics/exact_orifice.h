// The regurgitant orifice as geometry instead of pixels: the annulus polygon minus the union of the
// projected leaflets (thesis 4.2.1 without its image).
//
// The leaflets' outlines (silhouette.h) are taken away from that polygon in the plane
// (openings.h). The leaflets' thickness is that of the raster: their union grown by a disc; a face
// seen edge-on covers nothing by itself and grows to its full thickness. Accuracy: 1e-4 mm times
// the outline's length at worst, 0.01 mm2 for an orifice of 100 mm2; raw, a hundredth of that; in
// WebAssembly that of swept_openings(). What the loop of the annulus winds round counts as inside
// it, where its projection crosses itself also (the raster takes even and odd there). Limits:
// coordinates over 1 m are taken as 1 m; as for the raster, one direction of view.
#pragma once

#include <vector>

#include "core/closure/closure_result.h"
#include "core/metrics/orifice.h"
#include "core/metrics/projection.h"

namespace coapt {

struct ExactOrifice {
  double area_mm2 = 0.0;          ///< leaflets with their half thickness; NaN if the union failed
  double area_raw_mm2 = 0.0;      ///< leaflets as bare mid-surfaces; NaN likewise
  std::vector<Orifice> orifices;  ///< with half thickness, largest first
};

/// @param projection of this valve, finite.
/// @param half_thickness_mm by which the leaflets' mid-surfaces are grown in the view, >= 0.
ExactOrifice exact_orifice(const Valve& valve, const Projection& projection,
                           double half_thickness_mm);

/// The same on the annulus's plane of best fit.
ExactOrifice exact_orifice(const Valve& valve, const Points& closed_mm, double half_thickness_mm);

/// The line around an orifice and those around islands of tissue in it, each closed, as high as the
/// tissue beside it (edge_heights.h): a membrane across it lies where the valve is open.
struct OrificeOutline {
  double area_mm2 = 0.0;
  /// n x 3 each, the outer one first; corners 0.01 mm apart or more.
  std::vector<Points> contours_mm;
};

/// Of the orifices that exact_orifice() finds, in that order, without specks; empty if the union
/// failed.
std::vector<OrificeOutline> orifice_outlines(const Valve& valve, const Points& closed_mm,
                                             double half_thickness_mm);

/// Area within `outline` that is farther than `half_thickness_mm` from every line of `tissue`, as exact as the orifice;
/// NaN if the union fails.
/// @param outline closed, n points, either direction.
/// @param tissue open lines, each of at least two points, within 1 m.
double free_area_mm2(const std::vector<Vec2>& outline, const std::vector<std::vector<Vec2>>& tissue,
                     double half_thickness_mm);

/// Regurgitant orifice after thesis 4.2.1.
struct OrificeMeasure {
  double area_mm2 = 0.0;          ///< leaflets with their half thickness
  double area_raw_mm2 = 0.0;      ///< leaflets as bare mid-surfaces
  double area_mean_mm2 = 0.0;     ///< mean of area_mm2 over the closely spaced end states
  std::vector<Orifice> orifices;  ///< with half thickness, largest first
};

/// On that plane, with the tissue's thickness, and the mean over the end states.
OrificeMeasure measure_orifice(const Valve& valve, const ClosureResult& closure);

}  // namespace coapt
