// Triangle meshes in the formats that segmentation tools write: OBJ, PLY (ASCII and binary), STL
// (ASCII and binary), glTF, legacy VTK. Unstructured grids of XML VTK: vtu.h.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/valve/types.h"

namespace coapt {

/// What a file has and no reader uses: columns of a table, arrays of a mesh.
struct LeftOver {
  std::vector<std::string> names{};  ///< as in the file: may be a person's
  std::size_t of = 0;                ///< columns or arrays in all
};

struct TriangleMesh {
  Points vertices_mm;           ///< n x 3
  Faces faces;                  ///< m x 3
  std::vector<int> polygons{};  ///< m: which polygon or cell of the file each is of, from 0
  LeftOver arrays{};            ///< of its points, polygons or cells
};

/// What a mesh may have at most, its polygons counted as the triangles that they are split into. A segmented leaflet has thousands; the
/// usual limits keep a hostile file within some hundred megabytes.
struct MeshLimits {
  std::size_t vertices = 2'000'000, faces = 4'000'000;

  /// More than any file of such a mesh has: places and displacements, corners and labels of cells.
  std::size_t numbers() const { return 6 * (vertices + faces); }
};

/// One after the other; `polygons` and `arrays` are left out.
TriangleMesh joined(const std::vector<TriangleMesh>& meshes);

/// What the arrays of a .vtp or .vtu may unpack to, all together: of files of one's own, a mesh of a million triangles, twice what
/// an import takes, has some 45 MiB; of what a service is sent, no more than it takes without compression.
inline constexpr std::size_t kMostUnpacked = std::size_t{96} << 20;
inline constexpr std::size_t kMostUnpackedSent = std::size_t{8} << 20;

/// @param format "obj", "ply", "stl", "glb", "gltf", "vtk", "vtp" or "vtu". Polygons are split into fans; STL vertices are welded.
Expected<TriangleMesh> read_mesh(std::string_view bytes, std::string_view format,
                                 std::size_t most_unpacked = kMostUnpackedSent,
                                 const MeshLimits& limits = {});

}  // namespace coapt
