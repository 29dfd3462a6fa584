#pragma once

#include "core/valve/types.h"

namespace coapt {

/// Unit normals at the vertices, |V| x 3: means of the faces around, by area; zero where these cancel or there are none.
Points vertex_normals(const Points& vertices_mm, const Faces& faces);

}  // namespace coapt
