#pragma once

#include <random>

namespace coapt {

/// In [0, 1), uniform: the same numbers with every standard library, whose distributions differ.
inline double random_share(std::mt19937_64& engine) {
  return static_cast<double>(engine() >> 11) * 0x1p-53;
}

}  // namespace coapt
