// Valves to start from.
#pragma once

#include <string>
#include <vector>

#include "core/presets/taut_valve.h"

namespace coapt {

/// In the order in which programs list them.
const std::vector<std::string>& preset_names();

/// One of preset_names(), with about `triangles` triangles (0: the preset's own number). Errors: no preset of that name, or a
/// number of triangles out of range.
Expected<Valve> make_preset(const std::string& name, int triangles = 0);

}  // namespace coapt
