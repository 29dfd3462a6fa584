// glTF 2.0 (Khronos, glTF 2.0 specification): .glb, and .gltf with its buffers inside. Read are the meshes of the scene as they are shown at
// rest: where their nodes put them, with the default weights of their morph targets; every primitive is a group under the names of
// its node and mesh.
//
// The reader is our own, as those of images (io/image/label_map.h): Debian's tinygltf 2.7 opens the files that a document names, and ends
// the program where 200,000 brackets are nested.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "io/mesh/grouped_mesh.h"

namespace coapt {

/// "glb" or "gltf".
inline bool is_gltf_format(std::string_view format) { return format == "glb" || format == "gltf"; }

/// In the file's lengths, metres by the specification. Errors: compressed meshes (Draco, meshopt), sparse arrays, skins, what lies outside of
/// its buffer, pointers into the document.
Expected<GroupedMesh> read_gltf(std::string_view bytes, const MeshLimits& limits = {});

/// The file beside a .gltf that its buffer is in; none: it is inside. Errors without a path: several files, or one in another folder.
Expected<std::optional<std::string>> gltf_buffer_file(std::string_view bytes);

/// With that file's bytes inside, as .glb. @pre gltf_buffer_file(bytes) has a name
std::string gltf_with_buffer(std::string_view bytes, std::string_view buffer);

}  // namespace coapt
