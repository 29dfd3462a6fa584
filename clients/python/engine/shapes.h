// Closed shapes as documents and files.
#pragma once

#include <string>

#include "clients/python/engine/local_valve.h"
#include "core/metrics/shape_comparison.h"
#include "io/mesh/mesh_file.h"

namespace coapt {

/// The closed leaflets as requests take a mesh. Throws Problems: it diverged.
std::string shape_document(const LocalClosure& closed);

/// The closed valve as a file, by the end of its path. Throws Problems.
std::string file_of(const LocalClosure& closed, const std::string& path, bool open);

/// A mesh's file. Throws Problems.
TriangleMesh mesh_of_file(std::string_view bytes, const std::string& format);
std::string file_of(const TriangleMesh& mesh, const std::string& format, const std::string& doubt);

}  // namespace coapt
