#pragma once

#include <string_view>

#include "io/mesh/mesh_file.h"

namespace coapt {

Expected<TriangleMesh> read_obj(std::string_view text);

}  // namespace coapt
