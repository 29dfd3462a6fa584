// What each leaflet of a valve with any number of them does: its area, and how much of it lies on
// the nearest other leaflet.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/valve/valve.h"

namespace coapt {

struct LeafletMeasure {
  std::string name;
  double rest_area_mm2 = 0.0, closed_area_mm2 = 0.0;
  /// Share of the closed area nearer than the contact distance to another leaflet (its vertices
  /// stand for a third of the faces around them; those that it shares with others are left out).
  double contact_share = 0.0;
  double stretch_median = 1.0;  ///< largest principal stretch of its faces
};

/// In the order of leaflet_index(). `contact_distance_mm`: 0: kContactThicknesses x Tissue::thickness_mm.
std::vector<LeafletMeasure> measure_leaflets(const Valve& valve, const Points& closed_mm,
                                             double contact_distance_mm = 0.0);

/// Coaptation area index of a mitral valve: the share of the closed leaflets' area nearer than 1.25
/// thicknesses to the other side (leaflet_sides.h), counted as contact_share. NaN unless the points are
/// finite. After repairs of Barlow valves 0.20 +- 0.05 was found (Aguilera et al. 2023, JTCVS Open 13:95).
double coaptation_area_index(const Valve& valve, const Points& closed_mm);

/// Larger and smaller principal stretch of a triangle, from its rest to its closed corners.
std::array<double, 2> principal_stretches(const std::array<Vec3, 3>& rest_mm,
                                          const std::array<Vec3, 3>& closed_mm);

}  // namespace coapt
