// A valve as a scene of glTF 2.0, which browsers, presentation programs and VR viewers open.
//
// Metres, y to the atrium, x posteromedial, z posterior (glTF wants y up). Leaflets coloured by segment, as thick as they are,
// chordae as tubes, ring and sutures of a repair. What is there is the closed valve; the states on
// the way to it are morph targets, evenly spaced by how far the leaflets move, and the animation "closing" plays
// them in 1.5 s and holds the end for 1 s. The way is the relaxation's, not that of real time.
#pragma once

#include "io/exchange/exported_valve.h"

namespace coapt {

/// Without motion_mm there are no targets. @pre the closure is finite
std::string write_glb(const ClosedValve& exported);

/// The same scene, unstressed and still.
std::string write_open_glb(const ClosedValve& exported);

}  // namespace coapt
