// Names that nobody can guess or forge.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace coapt {

/// Two digits a byte, in lower case.
std::string hexadecimal(std::span<const unsigned char> bytes);

/// SHA-256 of the bytes, 64 hexadecimal digits.
std::string content_id(std::string_view bytes);

/// 128 random bits, 32 hexadecimal digits.
std::string random_id();

}  // namespace coapt
