// The parts that one file of meshes holds: objects, groups or materials of OBJ, solids of STL, what an array of the cells
// or points numbers in VTK's formats or a property of the faces in PLY, else pieces that do not hang together.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "io/mesh/mesh_file.h"

namespace coapt {

struct MeshPart {
  std::string
      name;  ///< in the file: may be a person's; of an array of cells its name and the number
  TriangleMesh mesh;  ///< may have no faces
  Points line_mm;     ///< n x 3, its lines in the order in which they hang together; may be empty
};

struct MeshParts {
  std::vector<MeshPart> parts;  ///< one at least
  std::string told_apart_by =
      "";  ///< "objects", "solids", "the array leaflet of the cells", "connected components"
  LeftOver arrays = {};  ///< but the one that tells the parts apart
};

/// @param format as of read_mesh(). Pieces of less than 5 % of the area are of the largest piece.
Expected<MeshParts> read_mesh_parts(std::string_view bytes, std::string_view format,
                                    std::size_t most_unpacked);

/// Lines of a file as one loop or line: OBJ, legacy VTK, .vtp. Errors: "/lines", there are none, or several that do not hang together.
/// Without lines and faces the points, in their order.
Expected<Points> read_mesh_line(std::string_view bytes, std::string_view format);

}  // namespace coapt
