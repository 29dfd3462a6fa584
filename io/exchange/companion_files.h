// Files that come in several: a header and its voxels (.nhdr, .mhd), a .gltf and its buffer, a multi-block of VTK (.vtm) and its pieces.
#pragma once

#include "io/exchange/formats.h"
#include "io/mesh/import_valve.h"

namespace coapt {

/// The other files that it is made of, by their names relative to its own folder and below; mostly none. Errors without a path.
Expected<std::vector<std::string>> companions_of(const NamedFile& file);

struct CompleteFiles {
  std::vector<NamedFile> files;
  std::vector<std::size_t> given;  ///< which of the files given each is, or begins with
  std::vector<ImportDecision> decisions;
};

/// Voxels and buffers joined to their headers; pieces of a .vtm under the names of its blocks. Errors at "/files/I": a companion is not there.
Expected<CompleteFiles> completed(std::vector<NamedFile> files);

}  // namespace coapt
