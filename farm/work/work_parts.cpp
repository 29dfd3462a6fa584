#include "farm/work/work_parts.h"

namespace coapt {

const std::string* named_part(const JsonPlace& place, const WorkRequest& request) {
  const int most = static_cast<int>(request.parts.size()) - 1;
  const int part = read_integer(place);
  if (part == kNoInteger) return nullptr;
  if (part >= 1 && part <= most) return &request.parts[static_cast<std::size_t>(part)];
  add_problem(place, ErrorCode::BadReference,
              "is " + std::to_string(part) + ", must be a part from 1 to " + std::to_string(most));
  return nullptr;
}

void pack(std::string& bytes, std::uint64_t value) {
  for (int byte = 0; byte < 8; ++byte) bytes += static_cast<char>(value >> (8 * byte) & 0xff);
}

std::uint64_t unpacked(std::string_view bytes, std::size_t at) {
  std::uint64_t value = 0;
  for (std::size_t byte = 0; byte < 8; ++byte)
    value |= std::uint64_t{static_cast<unsigned char>(bytes[at + byte])} << (8 * byte);
  return value;
}

void pack_text(std::string& bytes, const std::string& text) {
  pack(bytes, std::uint64_t{text.size()});
  bytes += text;
}

std::optional<std::string> take_text(std::string_view& bytes) {
  if (bytes.size() < 8) return std::nullopt;
  const std::uint64_t size = unpacked(bytes, 0);
  bytes.remove_prefix(8);
  if (size > bytes.size()) return std::nullopt;
  std::string text(bytes.substr(0, size));
  bytes.remove_prefix(size);
  return text;
}

}  // namespace coapt
