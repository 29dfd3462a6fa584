#pragma once

#include <string_view>

#include "io/mesh/grouped_mesh.h"

namespace coapt {

/// Grouped by the first of objects, groups and materials that differ.
Expected<GroupedMesh> read_obj_file(std::string_view text);

/// Its faces alone.
Expected<TriangleMesh> read_obj(std::string_view text);

}  // namespace coapt
