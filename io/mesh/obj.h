#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "io/mesh/mesh_file.h"

namespace coapt {

struct ObjLine {
  int group = 0;
  std::vector<int> points;  ///< indices of vertices
};

struct ObjFile {
  TriangleMesh mesh;  ///< may have no faces
  std::vector<ObjLine> lines;
  std::vector<std::string> groups;    ///< names, as they come
  std::vector<int> group_of_polygon;  ///< by TriangleMesh::polygons
  const char* grouped_by = "";        ///< "objects", "groups" or "materials": the first that differ
};

Expected<ObjFile> read_obj_file(std::string_view text);

/// Its faces alone.
Expected<TriangleMesh> read_obj(std::string_view text);

}  // namespace coapt
