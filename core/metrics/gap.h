// The opening between the two sides in three dimensions: the area of the smallest membrane that
// spans between them. What searches estimate a leak by (leak_estimate.h).
//
// A line along the anterior side, from where the sides meet at one commissure to where they meet at
// the other, bounds such a membrane: at each place it reaches to the nearest point of the posterior
// side, and is as wide as that is far, less the thickness (half of either leaflet's). The line of
// the smallest area is the throat of the leak: Dijkstra's shortest way along a net over the side
// (side_net.h), where a step costs its mean width times the mean of its length in space and of the
// way that the nearest point goes: of the membrane's two borders, of which on a bend one is longer.
//
// A width is zero where the mid-surfaces are no farther apart than the thickness, so widths are as
// continuous in the vertices as distances are. The line runs along the anterior side because that
// has no clefts: along the posterior one it would run around each of them, though scallops that
// touch each other shut it.
//
// Limits: nearest points jump where the line passes a hole in the posterior side (a cleft, a scallop
// far off) or a ridge. Beside a flail segment a third of a leak is missed.
#pragma once

#include "core/valve/valve.h"

namespace coapt {

/// Where anterior tissue is missing from annulus to edge, the line runs straight on to a vertex
/// beyond. Sides that have no vertex in common are measured between the outermost anterior
/// vertices.
/// @param closed_mm |V| x 3, finite
/// @return infinite if there is only one side
double gap_mm2(const Valve& valve, const Points& closed_mm);

}  // namespace coapt
