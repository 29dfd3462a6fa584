#pragma once

#include <string>
#include <vector>

#include "core/repair/plan.h"
#include "core/valve/leaflet_coordinates.h"

namespace coapt {

/// The plan in surgical words, one line a step ("annuloplasty: generic-classic ring, size 30 mm").
/// @param coordinates leaflet_coordinates(valve); null: they are not at hand
std::vector<std::string> describe(const Valve& valve, const RepairPlan& plan,
                                  const LeafletCoordinates* coordinates = nullptr);

/// "undersized by 2 sizes", "not undersized".
std::string undersizing_words(const OwnRing& ring);

}  // namespace coapt
