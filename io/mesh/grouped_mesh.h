// A mesh whose file sorts its faces and lines: by objects, groups or materials (OBJ), by nodes (glTF).
#pragma once

#include <string>
#include <vector>

#include "io/mesh/mesh_file.h"

namespace coapt {

struct GroupedLine {
  int group = 0;
  std::vector<int> points;  ///< indices of vertices
};

struct GroupedMesh {
  TriangleMesh mesh;  ///< may have no faces
  std::vector<GroupedLine> lines;
  std::vector<std::string> groups;    ///< names, as they come
  std::vector<int> group_of_polygon;  ///< by TriangleMesh::polygons
  const char* grouped_by = "";        ///< "objects", "groups", "materials" or "nodes"
};

}  // namespace coapt
