// What numbers an option takes, said in its help and in the message that refuses another.
#pragma once

#include <CLI/CLI.hpp>
#include <charconv>
#include <limits>
#include <sstream>
#include <string>
#include <type_traits>

namespace coapt {

/// The whole argument must be one number of type T from `min` to `max`; NaN is none. (CLI11 by
/// itself lets unsigned numbers wrap around and NaN through its ranges.)
template <class T>
CLI::Validator number_from(T min, T max) {
  std::ostringstream range;
  range.precision(std::numeric_limits<double>::digits10);
  range << "from " << min << " to " << max;
  const std::string kind = std::is_integral_v<T> ? "a whole number " : "a number ";
  const auto check = [=, accepted = kind + range.str()](const std::string& text) -> std::string {
    T value = {};
    const char* const end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(text.data(), end, value);
    const bool inside = error == std::errc() && rest == end && value >= min && value <= max;
    return inside ? "" : "is " + text + ", must be " + accepted;
  };
  return {check, range.str(), ""};
}

}  // namespace coapt
