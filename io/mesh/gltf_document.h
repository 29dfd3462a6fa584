// The document of a glTF file and its arrays of numbers; gltf.h makes meshes of them.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/valve/problem_list.h"
#include "io/json/json.h"

namespace coapt {

/// The chunks of a .glb; a .gltf is all document. Errors without a path.
struct GltfChunks {
  std::string_view document, binary;
};
Expected<GltfChunks> gltf_chunks(std::string_view bytes);

/// A member, null if there is none or `object` is no object.
const Json& gltf_member(const Json& object, std::string_view name);

/// Access by index and type; everything that is wrong is a problem, and a stand-in is returned.
class GltfDocument {
 public:
  GltfDocument(Json document, std::string_view binary);

  const Json& root() const { return root_; }
  ProblemList& problems() { return problems_; }

  /// Entry `index` of the list `list` of the document; null and a problem: it is not there.
  const Json& entry(const char* list, long long index);

  /// Up to 2^31 - 1; `otherwise` if it is missing.
  long long whole(const Json& object, const char* name, long long otherwise,
                  const std::string& path);

  /// Numbers of a JSON array of `count`; none if it is missing, or has a problem.
  std::optional<std::vector<double>> numbers(const Json& object, const char* name,
                                             std::size_t count, const std::string& path);

  /// The numbers of an accessor of the type (SCALAR or VEC3), one after the other.
  std::vector<double> array(long long accessor, std::string_view type);

 private:
  std::string_view buffer(long long index);
  std::string_view view(long long index, long long& stride);

  Json root_;
  std::string_view binary_;
  std::vector<std::optional<std::string>> decoded_;  ///< of buffers in base64
  ProblemList problems_;
};

}  // namespace coapt
