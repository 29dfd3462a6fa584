// Valves with leaflets of exponential tissue.
#pragma once

#include "core/valve/valve.h"
#include "tests/scenes/small_valve.h"

namespace coapt {

/// small_valve() with three leaflets, of columns 0 to 2, 3 to 5 and 6 to 7.
inline Valve three_leaflets() {
  Valve valve = small_valve();
  valve.leaflets = {{"anterior", 0.65, {1.0, 0.124, 4.568}},
                    {"posterior", 0.5, {1.0, 0.188, 14.86}},
                    {"septal", 0.8, {1.2, 0.191, 17.75}}};
  for (Index f = 0; f < valve.faces.rows(); ++f)
    valve.face_leaflet.push_back(static_cast<int>(f / 4 / 3));
  valve.segments.clear();
  valve.landmarks = {};
  valve.tissue.thickness_mm = 0.4;
  return valve;
}

}  // namespace coapt
