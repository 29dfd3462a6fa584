// Valves to start from. They are closed once here, because their chordae are as long as in the
// closed, pressurised valve (thesis 2.2.2); that is why this is not in core/valve.
#pragma once

#include <string>
#include <vector>

#include "core/valve/parametric.h"

namespace coapt {

/// A parametric valve whose chordae are taut in its closed state (times dimensions.slack). The
/// lengths come from the mesh of about 650 triangles and are the same at every resolution. What
/// validate() would refuse is refused here, before anything is closed.
Expected<Valve> make_taut_valve(const ParametricValve& dimensions);

const std::vector<std::string>& preset_names();

/// One of preset_names(), with about `triangles` triangles (0: the preset's own number).
Expected<Valve> make_preset(const std::string& name, int triangles = 0);

}  // namespace coapt
