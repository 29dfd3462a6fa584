// Closed surfaces in files, for Context::surface_of.
#pragma once

#include "core/metrics/shape_comparison.h"
#include "io/exchange/shape_file.h"
#include "io/json/named_file.h"

namespace coapt {

/// By the end of its name: a mesh (shape_format_names()), a scene of the service (json), or points without triangles (csv), in mm.
Expected<LeafletMesh> read_surface_file(const NamedFile& file, const ShapeFileOptions& options);

}  // namespace coapt
