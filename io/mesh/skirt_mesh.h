// A skirt as the mesh of a valve: triangles, fibres, segments and the landmarks of its annulus.
#pragma once

#include "io/mesh/skirt.h"

namespace coapt {

/// Vertices, faces, fibres, segments and annulus of a valve that has none; the annulus under pressure is that at rest.
void add_mesh(const Skirt& skirt, Valve& valve);

/// Stations of the skirt; what was given moves to the nearest one.
Landmarks find_landmarks(const Skirt& skirt, const GivenLandmarks& given);

}  // namespace coapt
