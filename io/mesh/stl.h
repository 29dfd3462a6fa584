#pragma once

#include <string_view>

#include "io/mesh/mesh_file.h"

namespace coapt {

Expected<TriangleMesh> read_stl(std::string_view bytes);

}  // namespace coapt
