#include "clients/python/engine/shapes.h"

#include <utility>

#include "clients/python/engine/problems.h"
#include "core/closed/closed_shape.h"
#include "io/exchange/formats.h"
#include "io/json/comparison_json.h"
#include "io/mesh/write_mesh.h"

namespace coapt {

std::string shape_document(const LocalClosure& closed) {
  const Valve& valve = closed.closed.valve;
  if (!closed.closed.closure.closed_mm.allFinite())
    throw Problems({{ErrorCode::BadGeometry, "",
                     "diverged during closure; there is no closed shape to compare"}});
  Json mesh = to_json(shape_of(closed.closed));
  mesh["thickness_mm"] = valve.tissue.thickness_mm;
  return mesh.dump();
}

std::string file_of(const LocalClosure& closed, const std::string& path, bool open) {
  const FileFormat* const known = format_of_path(path);
  if (known == nullptr)
    throw Problems({{ErrorCode::Unsupported, "", path + " must end in one of " + format_names()}});
  return taken(write_valve_file(closed.closed, *known, {.open = open}));
}

TriangleMesh mesh_of_file(std::string_view bytes, const std::string& format) {
  return taken(read_mesh(bytes, format, kMostUnpacked));
}

std::string file_of(const TriangleMesh& mesh, const std::string& format, const std::string& doubt) {
  return taken(write_mesh(mesh, format, doubt));
}

}  // namespace coapt
