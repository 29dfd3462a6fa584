#include "clients/python/engine/shapes.h"

#include <utility>

#include "clients/python/engine/problems.h"
#include "core/closed/closed_shape.h"
#include "io/exchange/formats.h"
#include "io/json/comparison_json.h"
#include "io/mesh/write_mesh.h"

namespace coapt {
std::string shape_document(const LocalClosure& closed) {
  const Valve& valve = *closed.repaired;
  if (!closed.closure.closed_mm.allFinite())
    throw Problems({{ErrorCode::BadGeometry, "",
                     "diverged during closure; there is no closed shape to compare"}});
  Json mesh = to_json(shape_of(ClosedValve{valve, closed.closure, closed.measure}));
  mesh["thickness_mm"] = valve.tissue.thickness_mm;
  return mesh.dump();
}

std::string file_of(const LocalClosure& closed, const std::string& path, bool open) {
  const FileFormat* const known = format_of_path(path);
  if (known == nullptr)
    throw Problems({{ErrorCode::Unsupported, "", path + " must end in one of " + format_names()}});
  const ClosedValve repaired{*closed.repaired, closed.closure, closed.measure};
  return taken(
      write_valve_file(with_repair(repaired, *closed.valve, closed.plan), *known, {.open = open}));
}

TriangleMesh mesh_of_file(std::string_view bytes, const std::string& format) {
  return taken(read_mesh(bytes, format, kMostUnpacked));
}

std::string file_of(const TriangleMesh& mesh, const std::string& format) {
  return taken(write_mesh(mesh, format));
}

}  // namespace coapt
