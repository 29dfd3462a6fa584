// The orifice along directions beside the annulus's normal, for eccentric jets (thesis 4.4.3).
//
// Counted are the straight lines of one direction that the loop of the annulus winds round and that
// keep half a thickness away from every leaflet, as area across that direction. Each such line runs
// through the mouth between the free edges: leaflets and mouth together span the annulus, so a line
// that crosses this surface must do so in the mouth. The area is thus that of a straight passage
// from ventricle to atrium, at most that of any surface that spans the opening; of several
// directions the largest is the best of these lower bounds. It never exceeds what leaks, and it
// finds what the view from the atrium hides: beside a prolapsing posterior leaflet lines are free
// that lean anteriorly, as the jet of such a valve does. An opening without any straight passage
// stays unseen.
//
// Cost: one exact orifice for each of 49 directions, 15 to 20 ms on a valve of 650 triangles.
#pragma once

#include "core/metrics/projection.h"

namespace coapt {

/// The direction that flow into the atrium takes, and what is open along it.
struct ObliqueOrifice {
  double area_mm2 = 0.0;     ///< leaflets with their half thickness, across the direction
  double tilt_deg = 0.0;     ///< from the annulus's normal, [0, 60]
  double azimuth_deg = 0.0;  ///< whither it leans: 0 posteromedially, 90 anteriorly, [0, 360)
};

/// Axes for a view along the normal tilted by that much; those of `plane` turned by the least
/// angle.
AnnulusFrame tilted(const AnnulusFrame& plane, double tilt_deg, double azimuth_deg);

/// The widest of 0, 10, ... 60 degrees of tilt at eight azimuths; the first of equal ones.
/// @param closed_mm |V| x 3, finite.
ObliqueOrifice oblique_orifice(const Valve& valve, const Points& closed_mm,
                               double half_thickness_mm);

}  // namespace coapt
