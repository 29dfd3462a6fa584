// Names by content.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace coapt {

/// Two digits a byte, in lower case.
std::string hexadecimal(std::span<const unsigned char> bytes);

/// SHA-256 of the bytes, 64 hexadecimal digits.
std::string sha256(std::string_view bytes);

}  // namespace coapt
