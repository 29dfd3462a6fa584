#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "io/mesh/mesh_file.h"

namespace coapt {

/// A number of each face of the file (TriangleMesh::polygons), of a type of whole numbers.
struct PlyNumbers {
  std::string name;
  std::vector<double> of_polygon;
};

struct PlyFile {
  TriangleMesh mesh;
  std::vector<PlyNumbers> face_numbers;
};

Expected<PlyFile> read_ply_file(std::string_view bytes, const MeshLimits& limits = {});

}  // namespace coapt
