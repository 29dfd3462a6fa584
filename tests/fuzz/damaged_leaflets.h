// Tiny leaflets of a funnel, damaged as bytes say.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "io/mesh/mesh_file.h"

namespace coapt {

/// @param shape bit 0: the first leaflet is a shell of two sides, bit 1: it is alone, bit 2: the second is a shell
/// @param bytes spent on vertices and faces, four at a time: moved, repeated, left out. Indices stay in range, coordinates may not
/// be finite
std::vector<TriangleMesh> damaged_leaflets(int shape, const std::uint8_t* bytes, std::size_t size);

/// Where they begin: 24 points, 18 mm from the axis.
Points round_annulus();

}  // namespace coapt
