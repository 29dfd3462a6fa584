// A closed surface in a request: {"mesh": numbers} or {"file": a file}, and what it is called.
#pragma once

#include <initializer_list>
#include <optional>
#include <string>
#include <vector>

#include "core/metrics/shape_comparison.h"
#include "io/exchange/shape_file.h"
#include "io/json/json_reader.h"
#include "io/json/named_file.h"
#include "operations/operation.h"

namespace coapt {

enum class Triangles { Required, Optional };

struct GivenShape {
  std::string source = {};  ///< as answers call it: by default the file's name, or "mesh"
  LeafletMesh mesh = {};
  std::optional<double> thickness_mm = {};
  std::optional<NamedFile> file = {};  ///< that read_files_of() has yet to read into `mesh`
  ShapeFileOptions reading = {};
  Triangles triangles = Triangles::Required;
};

/// Of a surface: twenty times the vertices of a valve, because one of images is as much finer, and twice as many triangles.
MeshLimits surface_limits(const OperationLimits& limits);

/// Errors: more vertices or triangles than that.
Errors check_surface(const LeafletMesh& mesh, const OperationLimits& limits);

/// As what a surface costs: its vertices, or half of its triangles if these are more than any sheet of so many vertices has.
Index size_of(const LeafletMesh& mesh);

/// Field "source": at most 1,000 bytes.
JsonField source_field(std::string& source);

/// Fields "mesh" {"vertices_mm", "faces", "names", "leaflets", "thickness_mm"}, "file" and, of a file, "leaflet_array" and
/// "displacement_array", and "source"; exactly one of the first two. A file is not read yet: that takes long, and read_files_of() does it.
/// @param triangles optional: points alone are a surface, too
void read_given_shape(const JsonPlace& place, const Context& context, GivenShape& shape,
                      Triangles triangles);

/// A shape of a request and its pointer there.
struct ShapeAt {
  GivenShape& shape;
  const char* path;
};

/// Reads the files of shapes that have one which is not read. All errors, below the shapes' paths.
Errors read_files_of(std::initializer_list<ShapeAt> shapes, const Context& context);

}  // namespace coapt
