// Valves to start from.
#pragma once

#include <string>
#include <vector>

#include "core/presets/taut_valve.h"

namespace coapt {

const std::vector<std::string>& preset_names();

/// One of preset_names(), with about `triangles` triangles (0: the preset's own number).
Expected<Valve> make_preset(const std::string& name, int triangles = 0);

}  // namespace coapt
