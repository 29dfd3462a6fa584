#pragma once

#include <cmath>
#include <random>

namespace coapt {

/// In [0, 1), uniform: the same numbers with every standard library, whose distributions differ.
inline double random_share(std::mt19937_64& engine) {
  return static_cast<double>(engine() >> 11) * 0x1p-53;
}

/// Normal of mean 0 and standard deviation 1 (Box and Muller 1958).
inline double normal_share(std::mt19937_64& engine) {
  const double radius = std::sqrt(-2.0 * std::log(1.0 - random_share(engine)));
  return radius * std::cos(2.0 * 3.14159265358979323846 * random_share(engine));
}

}  // namespace coapt
