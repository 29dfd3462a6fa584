// Closures, known by what they are made from, as bytes: what workers that run the same search give each other.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/closure/closure_result.h"
#include "core/valve/valve.h"

namespace coapt {

/// Of everything that a closure or an opening depends on: equal for equal values, and never for others in practice (128 bits).
using ClosureKey = std::array<std::uint64_t, 2>;

/// @param neighbour null: the closure starts from the open valve
ClosureKey closure_key(const Valve& valve, const ClosureOptions& options,
                       const ClosureResult* neighbour);
/// Of the valve opened by the defaults of open_valve().
ClosureKey opening_key(const Valve& valve);

std::string bytes_of(const ClosureResult& closure);
/// Bit by bit what bytes_of() was given. @pre bytes are of it.
ClosureResult closure_from(std::string_view bytes);

}  // namespace coapt
