// Bytes in JSON (RFC 4648).
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace coapt {

std::string encoded_base64(std::string_view bytes);

/// None if `text` is no base64 with padding.
std::optional<std::string> decoded_base64(std::string_view text);

}  // namespace coapt
