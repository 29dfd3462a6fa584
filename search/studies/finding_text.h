// Numbers in the words of a finding.
#pragma once

#include <string>
#include <vector>

#include "core/valve/number_text.h"

namespace coapt {

/// "12.3"; "n/a" if it is not finite.
inline std::string in_words(double value, int decimals) {
  if (!(value - value == 0.0)) return "n/a";
  return with_decimals(value, decimals);
}

inline std::string in_percent(double share, int decimals = 0) {
  return in_words(100.0 * share, decimals) + " %";
}

/// "1.2 / 3.4"
inline std::string in_words(const std::vector<double>& values, int decimals = 1) {
  std::string text;
  for (const double value : values) text += (text.empty() ? "" : " / ") + in_words(value, decimals);
  return text;
}

}  // namespace coapt
