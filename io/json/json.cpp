#include "io/json/json.h"

template class nlohmann::basic_json<nlohmann::ordered_map>;
template class nlohmann::detail::serializer<coapt::Json>;
template class std::vector<coapt::Json>;

namespace coapt {
namespace {

/// The code of a character that moves a terminal and that the library leaves as it is (DEL, C1, what overrides direction), else 0.
/// @param text UTF-8
unsigned control_at(const std::string& text, std::size_t i) {
  const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(text[i + k]); };
  if (byte(0) == 0x7F) return 0x7F;
  if (byte(0) == 0xC2 && byte(1) < 0xA0) return byte(1);
  if (byte(0) != 0xE2) return 0;
  const unsigned code = 0x2000u + ((byte(1) & 0x3Fu) << 6) + (byte(2) & 0x3Fu);
  return (code >= 0x202A && code <= 0x202E) || (code >= 0x2066 && code <= 0x2069) ? code : 0;
}

}  // namespace

std::string json_text(const Json& json, int indent) {
  std::string text = json.dump(indent, ' ', false, Json::error_handler_t::replace);
  std::string safe;
  std::size_t taken = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const unsigned code = control_at(text, i);
    if (code == 0) continue;
    safe.append(text, taken, i - taken).append("\\u");
    for (const unsigned shift : {12u, 8u, 4u, 0u})
      safe += "0123456789abcdef"[(code >> shift) & 0xFu];
    taken = i + (code < 0x80 ? 1 : code < 0x800 ? 2 : 3);
  }
  if (taken == 0) return text;
  return safe.append(text, taken);
}

}  // namespace coapt
