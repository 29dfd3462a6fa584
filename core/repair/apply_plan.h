#pragma once

#include <string>
#include <vector>

#include "core/repair/plan.h"
#include "core/valve/leaflet_coordinates.h"

namespace coapt {

/// The repaired valve. Vertices, faces, heads and chordae keep their indices; neochordae are
/// appended in the order of their text. The result does not depend on the order of the steps:
/// resections act first, then rings, then sutures, then chordae and edges. Errors point into the plan ("/steps/2/suture_length_mm")
/// and list every impossible step (slack suture, unknown chorda or ring, two steps on one chorda,
/// two rings, ...) or else the steps that leave a valve that validate() refuses.
/// @pre the valve is valid.
Expected<Valve> apply_plan(const Valve& valve, const RepairPlan& plan);
/// The same with leaflet_coordinates(valve) at hand, which are most of the time of a plan with neochordae.
Expected<Valve> apply_plan(const Valve& valve, const RepairPlan& plan,
                           const LeafletCoordinates& coordinates);

}  // namespace coapt
