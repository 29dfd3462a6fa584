// Numbers as text: the same in every locale, with a point.
#pragma once

#include <array>
#include <charconv>
#include <string>

namespace coapt {

inline std::string number_text(double number, std::chars_format format, int precision) {
  std::array<char, 400> text;  // the longest double has 309 digits before the point
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), number, format, precision).ptr;
  return {text.data(), end};
}

/// As %.*f: "12.30", "-0.0", "nan".
inline std::string with_decimals(double number, int decimals) {
  return number_text(number, std::chars_format::fixed, decimals);
}

/// As %.*g: "12.3", "1.2e+09", "nan".
inline std::string significant(double number, int digits) {
  return number_text(number, std::chars_format::general, digits);
}

/// Six significant digits.
inline std::string shown(double number) { return significant(number, 6); }

/// Of an estimate, so that it is never 0 or 100 %: "62 %"; to a tenth near the ends: "97.4 %", "> 99.9 %".
inline std::string probability_text(double probability, const std::string& over = "> ",
                                    const std::string& under = "< ") {
  const double value = 100.0 * probability;
  if (value > 99.95) return over + "99.9 %";
  if (value < 0.05) return under + "0.1 %";
  return with_decimals(value, value < 10.0 || value > 90.0 ? 1 : 0) + " %";
}

/// The same in a sentence: "more than 99.9 %".
inline std::string probability_words(double probability) {
  return probability_text(probability, "more than ", "less than ");
}

}  // namespace coapt
