#include "core/metrics/estimate_text.h"

#include <algorithm>
#include <cmath>

#include "core/valve/number_text.h"

namespace coapt {
namespace {

bool is_error(double error) { return std::isfinite(error) && error >= 0.0; }

int decimals_of(double error) {
  constexpr double kTwoDigitsBelow = 3.55, kNextDecadeFrom = 9.5;
  constexpr int kMostDecimals = 3;
  if (error == 0.0) return 1;
  const int exponent = static_cast<int>(std::floor(std::log10(error)));
  const double leading = error / std::pow(10.0, exponent);
  const bool next_decade = leading >= kNextDecadeFrom;
  const bool two_digits = leading < kTwoDigitsBelow || next_decade;
  return std::clamp((two_digits ? 1 : 0) - exponent - (next_decade ? 1 : 0), 0, kMostDecimals);
}

const char* error_words(ErrorCause cause) {
  switch (cause) {
    case ErrorCause::Numerical:
      return "numerical error";
    case ErrorCause::Tissue:
      return "tissue error";
    case ErrorCause::Execution:
      return "errors of execution";
  }
  return "";
}

}  // namespace

std::string fixed(double value, int decimals) {
  if (!std::isfinite(value)) return "n/a";
  std::string text = with_decimals(value, decimals);
  if (text.find_first_not_of("-0.") == std::string::npos && text[0] == '-') text.erase(0, 1);
  return text;
}

std::string with_error(double value, double error, std::string_view unit) {
  std::string text = known_digits(value, error);
  if (!std::isfinite(value)) return text;
  if (is_error(error)) text += " ± " + fixed(error, decimals_of(error));
  return unit.empty() ? text : text + " " + std::string(unit);
}

std::string known_digits(double value, double error) {
  return fixed(value, is_error(error) ? decimals_of(error) : 1);
}

std::string known_tenths(double value, double error) {
  constexpr double kTenths = 0.4;  // the least error that leaves no more digits
  return known_digits(value, std::fmax(kTenths, error));
}

std::string known_tenths(const Estimate& estimate, double units) {
  return known_tenths(units * estimate.value, units * half_width(estimate));
}

std::string interval_words(const Interval& interval) {
  const double half = 0.5 * (interval.high - interval.low);
  return known_tenths(interval.low, half) + " to " + known_tenths(interval.high, half);
}

EstimateWords words_of(const Estimate& estimate) {
  const std::optional<ErrorCause> cause = widest(estimate);
  if (!cause) return {fixed(estimate.value, 1), "", ""};
  const Interval wide = *part_of(estimate, *cause);
  if (*cause == ErrorCause::Numerical && wide.low <= estimate.value && estimate.value <= wide.high)
    return {with_error(estimate.value, wide.high - estimate.value), "", "± numerical error"};
  const std::string value = known_tenths(estimate);
  const std::string interval = interval_words(wide);
  if (*cause == ErrorCause::Tissue && tissue_excludes_value(estimate))
    return {interval, value, "with the tissue of its file"};
  return {value, interval, "with " + std::string(error_words(*cause)) + " (5 to 95 %)"};
}

}  // namespace coapt
