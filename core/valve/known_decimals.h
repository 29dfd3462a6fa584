// To how many places a number is known.
#pragma once

#include <algorithm>
#include <cmath>

namespace coapt {

/// Decimals that an error >= 0 leaves: two digits of an error below 3.55 of its power of ten, else one; a tenth of none.
inline int known_decimals(double error) {
  constexpr double kTwoDigitsBelow = 3.55, kNextDecadeFrom = 9.5;
  constexpr int kMostDecimals = 3;
  if (error == 0.0) return 1;
  const int exponent = static_cast<int>(std::floor(std::log10(error)));
  const double leading = error / std::pow(10.0, exponent);
  const bool next_decade = leading >= kNextDecadeFrom;
  const bool two_digits = leading < kTwoDigitsBelow || next_decade;
  return std::clamp((two_digits ? 1 : 0) - exponent - (next_decade ? 1 : 0), 0, kMostDecimals);
}

}  // namespace coapt
