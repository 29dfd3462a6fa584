// The bytes of an array in a VTK XML file. Plain: their number, then they. Compressed: the number of blocks, the size of a
// block and of the last one (0: whole), the compressed size of each; then the blocks. In base64 this head of a compressed
// array is coded apart from the rest.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/valve/types.h"

namespace coapt {

struct StoredBytes {
  std::string_view bytes;  ///< from the array's beginning on, to the end of what there is
  bool raw = false;        ///< else base64
  bool wide_header = false;
  std::string_view compressor;  ///< "", "vtkZLibDataCompressor" or "vtkLZMADataCompressor"
};

/// At most `most` bytes, which is known before one is unpacked. Errors have `path`: InputOutput (truncated or damaged),
/// Unsupported, OutOfRange.
Expected<std::string> unpacked(const StoredBytes& stored, const std::string& path,
                               std::size_t most);

/// Base64 without blanks; none: it is not.
std::optional<std::string> from_base64(std::string_view text);

/// `type`: VTK's names, "Float32" to "UInt64". At most `most` bytes of numbers.
Expected<std::vector<double>> numbers_of(std::string_view bytes, std::string_view type,
                                         const std::string& path, std::size_t most);

}  // namespace coapt
