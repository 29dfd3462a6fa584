// The opening between the two sides in three dimensions: the area of the smallest membrane that
// spans between them.
//
// A line along the anterior side, from where the sides meet at one commissure to where they meet at
// the other, bounds such a membrane: at each place it reaches to the nearest point of the posterior
// side, and is as wide as that is far, less the thickness (half of either leaflet's). The line of
// the smallest area is the throat of the leak: Dijkstra's shortest way along a net over the side
// (side_net.h), where a step costs its mean width times the mean of its length in space and of the
// way that the nearest point goes: of the membrane's two borders, of which on a bend one is longer.
//
// No plane is cut and no place is in contact or out of it: a width is zero where the mid-surfaces
// are no farther apart than the thickness, so widths are as continuous in the vertices as distances
// are, and the area is zero where the leaflets touch in a band from commissure to commissure. It
// needs no tolerance: leaflets pressed together rest at 0.85 to 1 times their thickness, and the
// line passes the facets of a coarse mesh where they are nearest. The line runs along the anterior
// side because that has no clefts: along the posterior one it would run around each of them, though
// scallops that touch each other shut it.
//
// Limits: nearest points jump where the line passes a hole in the posterior side (a cleft, a scallop
// far off) or a ridge. The triangle between the places before and behind is counted, what lies
// beyond it is not: beside a flail segment a third of a leak was missed. Such holes the atrial view
// shows, and the orifice counts them exactly.
#pragma once

#include <vector>

#include "core/valve/valve.h"

namespace coapt {

struct GapPlace {
  Vec3 anterior_mm = Vec3::Zero();   ///< on the line
  Vec3 posterior_mm = Vec3::Zero();  ///< the nearest point of the posterior side
  double width_mm = 0.0;             ///< between them, less the thickness; >= 0
};

struct Gap {
  double area_mm2 = 0.0;         ///< infinite if there is only one side
  std::vector<GapPlace> places;  ///< from the anterolateral commissure to the posteromedial one
};

/// Where anterior tissue is missing from annulus to edge, the line runs straight on to a vertex
/// beyond. Sides that have no vertex in common are measured between the outermost anterior
/// vertices.
/// @param closed_mm |V| x 3, finite
Gap measure_gap(const Valve& valve, const Points& closed_mm);

}  // namespace coapt
