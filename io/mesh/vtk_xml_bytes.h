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

/// What the arrays of a file may have as numbers of 8 bytes, however narrow they are stored, and what of it is left.
struct UnpackBudget {
  std::size_t most_bytes = 0, left_bytes = most_bytes;
};

struct StoredBytes {
  std::string_view bytes;  ///< from the array's beginning on, to the end of what there is
  bool raw = false;        ///< else base64
  bool wide_header = false;
  std::string_view compressor;  ///< "", "vtkZLibDataCompressor" or "vtkLZMADataCompressor"
};

/// The numbers of an array, which are taken off the budget. What is too large is refused before a byte is unpacked.
/// Errors have `path`: InputOutput (truncated or damaged), Unsupported, OutOfRange.
/// @param type VTK's names, "Float32" to "UInt64".
Expected<std::vector<double>> unpacked_numbers(const StoredBytes& stored, std::string_view type,
                                               const std::string& path, UnpackBudget& budget);

/// Base64 without blanks; none: it is not.
std::optional<std::string> from_base64(std::string_view text);

}  // namespace coapt
