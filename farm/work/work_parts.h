// What the kinds of work share: valves among the parts, numbers in packed answers.
#pragma once

#include <bit>
#include <cstdint>
#include <string>
#include <string_view>

#include "core/valve/valve.h"
#include "farm/work/work.h"
#include "io/json/json_reader.h"

namespace coapt {

/// The valve of the part that the integer at `place` names. Stand-in an empty valve. Problems of the valve's own document are
/// listed at `place`, each with its pointer in words.
Valve read_valve_part(const JsonPlace& place, const WorkRequest& request);

/// Little-endian, eight bytes each.
void pack(std::string& bytes, std::uint64_t value);
inline void pack(std::string& bytes, double value) {
  pack(bytes, std::bit_cast<std::uint64_t>(value));
}
/// @pre bytes holds eight from `at` on.
std::uint64_t unpacked(std::string_view bytes, std::size_t at);

}  // namespace coapt
