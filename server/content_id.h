// Names that nobody can guess or forge.
#pragma once

#include <string>
#include <string_view>

#include "io/store/sha256.h"

namespace coapt {

/// SHA-256 of the bytes, 64 hexadecimal digits.
std::string content_id(std::string_view bytes);

/// 128 random bits, 32 hexadecimal digits.
std::string random_id();

}  // namespace coapt
