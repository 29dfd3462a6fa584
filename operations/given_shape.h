// A closed surface in a request: {"mesh": numbers} or {"file": a file}, and what it is called.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/metrics/shape_comparison.h"
#include "io/json/json_reader.h"
#include "operations/operation.h"

namespace coapt {

struct GivenShape {
  std::string source = {};  ///< as answers call it: by default the file's name, or "mesh"
  LeafletMesh mesh = {};
  std::optional<double> thickness_mm = {};
};

/// Field "source": at most 1,000 bytes.
JsonField source_field(std::string& source);

enum class Triangles { Required, Optional };

/// Fields "mesh" {"vertices_mm", "faces", "names", "leaflets", "thickness_mm"}, "file" and, of a file, "leaflet_array" and
/// "displacement_array", and "source"; exactly one of the first two. Meshes have at most twenty times the vertices of a valve.
/// @param triangles optional: points alone are a surface, too
void read_given_shape(const JsonPlace& place, const Context& context, GivenShape& shape,
                      Triangles triangles);

}  // namespace coapt
