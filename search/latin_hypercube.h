// Samples of a box that spread over each of its sides.
#pragma once

#include <cstdint>
#include <vector>

namespace coapt {

/// A Latin hypercube (McKay 1979): `count` samples of `factors` shares in [0, 1].
std::vector<std::vector<double>> latin_hypercube(int count, int factors, std::uint64_t seed);

}  // namespace coapt
