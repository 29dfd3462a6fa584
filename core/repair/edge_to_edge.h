// Edge-to-edge repair: ties between opposite points of the free edges.
//
// A stitch is a row of ties along both edges, kTieSpacing_mm apart. A clip has a second row where the
// tips of its arms hold the leaflets. Each leaflet's own edge measures the width, so that neither is
// gathered. Modelled: leaflets held at the contact thickness. Not modelled: the clip's body between
// them, leaflet tissue that a suture gathers, stenosis in diastole.
#pragma once

#include <string>

#include "core/repair/plan.h"
#include "core/valve/problem_list.h"

namespace coapt {

inline constexpr double kTieSpacing_mm = 2.0;
/// Of the leaflets by a clip's arms, which are 9 to 12 mm long (assumed: half of it holds tissue).
inline constexpr double kClipGrasp_mm = 5.0;

bool check_edge_to_edge(const EdgeToEdge& step, const std::string& path, ProblemList& problems);

/// Equal for equal steps, and an order for those that differ.
std::string text_key(const EdgeToEdge& step);

/// Appends its ties, called "edge-to-edge-1-1" and so on, the first number that is free.
void apply_edge_to_edge(const EdgeToEdge& step, const LeafletCoordinates& coordinates,
                        Valve& valve);

}  // namespace coapt
