// Numbers in the words of a finding.
#pragma once

#include <cstdio>
#include <string>

namespace coapt {

/// "12.3"; "n/a" if it is not finite.
inline std::string in_words(double value, int decimals) {
  if (!(value - value == 0.0)) return "n/a";
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", decimals, value);
  return text;
}

inline std::string in_percent(double share, int decimals = 0) {
  return in_words(100.0 * share, decimals) + " %";
}

}  // namespace coapt
