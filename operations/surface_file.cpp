#include "operations/surface_file.h"

#include "io/exchange/import_files.h"
#include "io/mesh/import_readers.h"

namespace coapt {

Expected<LeafletMesh> read_surface_file(const NamedFile& file, const ShapeFileOptions& options) {
  const std::string format = format_of(file.name);
  if (is_shape_format(format)) return read_shape(file.bytes, format, options);
  if (format == "json") return read_scene_shape(file.bytes, options.limits);
  if (format != "csv")
    return Error{
        ErrorCode::Unsupported, "/name",
        "must end in one of " + shape_format_names() + ", json (a scene) or csv (x,y,z lines)"};
  const Expected<Points> points = read_points_csv(file.bytes);
  if (!points) return points.errors();
  LeafletMesh cloud;
  cloud.vertices_mm = *points;
  if (stated_axes(file.bytes) == PatientAxes::RAS) turn_axes(cloud.vertices_mm);
  cloud.faces.resize(0, 3);
  return cloud;
}

}  // namespace coapt
