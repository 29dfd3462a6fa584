// Counts in words, with the noun that goes with them.
#pragma once

#include <string>
#include <string_view>

namespace coapt {

/// The noun of so many: "closure" of 1, else "closures", or `many`.
inline std::string noun_of(long long count, std::string_view one, std::string_view many = {}) {
  if (count == 1) return std::string(one);
  return many.empty() ? std::string(one) + 's' : std::string(many);
}

/// "1 closure", "0 closures", "2 chordae".
inline std::string counted(long long count, std::string_view one, std::string_view many = {}) {
  return std::to_string(count) + ' ' + noun_of(count, one, many);
}

}  // namespace coapt
