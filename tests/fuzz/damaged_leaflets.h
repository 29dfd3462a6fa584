// Tiny leaflets of a funnel, damaged as bytes say, and what is given with them.
#pragma once

#include <cstddef>
#include <cstdint>

#include "io/mesh/import_valve.h"

namespace coapt {

/// @param given bit 0: the first leaflet is a shell of two sides, bit 1: it is alone, bit 2: the second is a shell, bit 3: there is no
/// annulus, bit 4: there are tips
/// @param bytes spent on vertices and faces, four at a time: moved, repeated, left out. Indices stay in range, coordinates may not
/// be finite
ImportSource damaged_source(int given, const std::uint8_t* bytes, std::size_t size);

}  // namespace coapt
