// Arithmetic of values that wrap: shares of a turn, as LeafletCoordinates::around.
#pragma once

#include <cmath>

namespace coapt {

/// A difference taken the shorter way, within half a turn.
inline double wrapped(double difference) { return difference - std::round(difference); }

/// The value within [0, 1).
inline double turn_fraction(double around) {
  const double fraction = around - std::floor(around);
  return fraction < 1.0 ? fraction : 0.0;
}

}  // namespace coapt
