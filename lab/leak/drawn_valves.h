// Valves of many kinds, ill and repaired, for measures of the leak to be compared on.
#pragma once

#include <cstdint>
#include <string>

#include "core/valve/valve.h"

namespace coapt {

struct DrawnValve {
  std::string name;    ///< what it was made from
  std::string repair;  ///< "none", "ring", "clip", "neochordae" (two), "ring+clip"
  Valve valve;
};

/// Number 0 and so on: first the presets as they are, in their order; then presets and (every other one) human valves with clefts of 1
/// to 5 mm, remodelled: AP dilation 0 to 26 %, annular height 60 to 120 %, each tip displaced by up to 6 mm; a fifth of them with each
/// repair: the valve's own ring, 0 to 3 sizes below; a clip of 4 to 6 mm in the middle third; neochordae to either half of a leaflet, as
/// long as its head's marginal chordae or up to 15 % shorter. The same arguments give the same valve.
DrawnValve drawn_valve(int number, std::uint64_t seed);

}  // namespace coapt
