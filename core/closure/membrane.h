// Which membrane carries the leaflets' tension.
#pragma once

namespace coapt {

/// Springs: one per edge (model.h). Continuum: constant-strain triangles (continuum.h).
enum class Membrane { Springs, Continuum };

const char* to_string(Membrane membrane);

}  // namespace coapt
