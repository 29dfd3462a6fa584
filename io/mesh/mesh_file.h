// Triangle meshes in the formats that segmentation tools write: OBJ, PLY (ASCII and binary), STL
// (ASCII and binary), legacy VTK (ASCII). Unstructured grids of XML VTK: vtu.h.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/valve/types.h"

namespace coapt {

struct TriangleMesh {
  Points vertices_mm;           ///< n x 3
  Faces faces;                  ///< m x 3
  std::vector<int> polygons{};  ///< m: which polygon or cell of the file each is of, from 0
};

/// One after the other; `polygons` are left out.
TriangleMesh joined(const std::vector<TriangleMesh>& meshes);

/// @param format "obj", "ply", "stl" or "vtk". Polygons are split into fans; STL vertices are welded.
Expected<TriangleMesh> read_mesh(std::string_view bytes, std::string_view format);

/// The same, also "vtp" and "vtu", whose arrays may be compressed, up to 128 MiB each: for files of one's own, not for
/// what a service is sent.
Expected<TriangleMesh> read_packed_mesh(std::string_view bytes, std::string_view format);

}  // namespace coapt
