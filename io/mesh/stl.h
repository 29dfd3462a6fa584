#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "io/mesh/mesh_file.h"

namespace coapt {

struct StlFile {
  TriangleMesh mesh;
  std::vector<std::string> solids;    ///< names; of a text file
  std::vector<int> solid_of_polygon;  ///< by TriangleMesh::polygons; of a text file
};

Expected<StlFile> read_stl_file(std::string_view bytes, const MeshLimits& limits = {});

/// All of its solids together.
Expected<TriangleMesh> read_stl(std::string_view bytes, const MeshLimits& limits = {});

}  // namespace coapt
