// Numbers in a binary file.
#pragma once

#include <bit>
#include <cstring>
#include <optional>
#include <string_view>

namespace coapt {

/// Takes a T of the given byte order from the front of `bytes`; none if too few are left.
template <class T>
std::optional<T> take_binary(std::string_view& bytes, std::endian order) {
  if (bytes.size() < sizeof(T)) return {};
  char raw[sizeof(T)];
  for (std::size_t i = 0; i < sizeof(T); ++i) {
    raw[i] = bytes[order == std::endian::native ? i : sizeof(T) - 1 - i];
  }
  bytes.remove_prefix(sizeof(T));
  T value;
  std::memcpy(&value, raw, sizeof(T));
  return value;
}

}  // namespace coapt
