#pragma once

#include <cstddef>
#include <string_view>

#include "core/valve/types.h"
#include "io/json/json.h"

namespace coapt {

constexpr std::size_t kMaxJsonValues = 8'000'000;  ///< the largest valve has 6 million

/// The document, or InvalidJson with the pointer to where reading stopped. Members are in the order
/// of their names: theirs in the text means nothing. Refused: more than 64 MiB, 32 levels or
/// `max_values` values, a name twice in one object or longer than 256 bytes, NaN, numbers beyond
/// double (OutOfRange), anything that RFC 8259 does not allow, such as a NUL after the document.
/// Throws std::bad_alloc where there is no memory, with what was read so far freed.
Expected<Json> parse_json(std::string_view text, std::size_t max_values = kMaxJsonValues);

/// Empties a document without taking memory. The library's destructor takes some for what is nested, and where there is
/// none it ends the process.
void take_apart(Json& value);

}  // namespace coapt
