// Edge-to-edge repair: ties between opposite points of the free edges.
//
// A stitch is a row of ties along both edges, kTieSpacing_mm apart. A clip has rows of them from the free edges to where its arms
// end on the leaflets: 5 mm above (assumed) of arms that are 9 mm long (MitraClip NT, NTR) or 12 mm (XT, XTR: 3 mm more, EuroPCR
// 2019). Each leaflet's own edge measures the width, so that neither is gathered.
// A clip draws the annulus in, mostly in its anteroposterior diameter: by 13.2 +- 8.8 % in functional, 8.6 +- 7.5 % in organic
// regurgitation (50 procedures, REC: Interventional Cardiology); 11 % unless told. The largest of several clips counts.
// Sutures of a cleft are ties between its two edges, from its root on, kTieSpacing_mm apart.
// Modelled: leaflets held at the contact thickness. Not modelled: leaflet tissue that a suture gathers, the clip's own stiffness.
#pragma once

#include <string>

#include "core/repair/plan.h"
#include "core/valve/problem_list.h"

namespace coapt {

inline constexpr double kTieSpacing_mm = 2.0;

bool check_edge_to_edge(const EdgeToEdge& step, const std::string& path, ProblemList& problems);

/// Equal for equal steps, and an order for those that differ.
std::string text_key(const EdgeToEdge& step);

/// Draws the annulus in as the clips of a plan do; without clips or behind a ring nothing.
void draw_annulus_in(const RepairPlan& plan, Valve& valve);

/// A stitch that closes a commissure: over `width_mm` of both free edges, from where the leaflets meet.
EdgeToEdge commissural_closure(const Valve& valve, const LeafletCoordinates& coordinates, Side side,
                               double width_mm);

/// Appends its ties, called "edge-to-edge-1-1" and so on, the first number that is free.
void apply_edge_to_edge(const EdgeToEdge& step, const LeafletCoordinates& coordinates,
                        Valve& valve);

}  // namespace coapt
