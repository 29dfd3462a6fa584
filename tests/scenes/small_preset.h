// Presets for tests, made once in a process.
#pragma once

#include <string>

#include "core/valve/valve.h"

namespace coapt {

/// make_preset(name, triangles).
const Valve& shared_preset(const std::string& name, int triangles = 0);

/// For questions that are not about the mesh: with about 200 triangles a preset closes in a sixth of the time, and leaks or closes
/// as on its own mesh.
const Valve& small_preset(const std::string& name);

}  // namespace coapt
