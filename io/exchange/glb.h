// glTF 2.0 binary (Khronos glTF 2.0 specification, 4.4): one JSON chunk, one buffer.
#pragma once

#include <string>
#include <vector>

#include "core/valve/types.h"
#include "io/json/json.h"

namespace coapt {

using Colour8 = std::array<std::uint8_t, 4>;  ///< linear red, green, blue, alpha

/// Collects arrays in the buffer; each returns the index of its accessor. Single precision.
class GlbBuffer {
 public:
  /// Positions and their differences have their bounds given, as the specification asks.
  int add_vectors(const Points& vectors, bool bounds);
  int add_colours(const std::vector<Colour8>& colours);
  int add_triangles(const Faces& faces);
  int add_scalars(const std::vector<double>& scalars, bool bounds);

  /// The whole file: `document` with buffers, bufferViews and accessors added.
  std::string file(Json document) const;

 private:
  int add(Json accessor, std::size_t start, int target);
  void append(float number);

  std::string bytes_;
  Json views_ = Json::array();
  Json accessors_ = Json::array();
};

}  // namespace coapt
