#pragma once

#include <string_view>

#include "io/mesh/grouped_mesh.h"

namespace coapt {

/// Grouped by the first of objects, groups and materials that differ. It may have as many lines and names as triangles.
Expected<GroupedMesh> read_obj_file(std::string_view text, const MeshLimits& limits = {});

/// Its faces alone.
Expected<TriangleMesh> read_obj(std::string_view text, const MeshLimits& limits = {});

}  // namespace coapt
