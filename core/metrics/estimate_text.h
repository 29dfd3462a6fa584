// Numbers as text, to the digits that their errors leave.
#pragma once

#include <string>
#include <string_view>

#include "core/metrics/estimate.h"

namespace coapt {

/// With `decimals` places, a point in every locale; "n/a" if not finite; never "-0.0".
std::string fixed(double value, int decimals);

/// "45.7 ± 2.1 mm²", "46 ± 5": the error to two digits where they are 10 to 35, else to one, the value
/// to as many places (Particle Data Group 2022, 5.3). Without a finite error one place and no error;
/// "n/a" if the value is not finite.
std::string with_error(double value, double error, std::string_view unit = "");

/// The value alone, to those places: "45.7", "46".
std::string known_digits(double value, double error);

/// To a tenth, or to fewer digits where the error leaves no more; without one to a tenth.
std::string known_tenths(double value, double error);

/// The same of an estimate by its widest error, in so many of its units.
std::string known_tenths(const Estimate& estimate, double units = 1.0);

/// "0.1 to 3.5", "16 to 78": to a tenth, or to fewer digits where half its width leaves no more.
std::string interval_words(const Interval& interval);

/// What is said of an estimate by the widest part of its error that is known: "46", "16 to 78" and "with tissue error
/// (5 to 95 %)"; of the computation's error "45.7 ± 2.1", no interval and "± numerical error". Where the tissue's interval excludes the
/// value, as draws weighed by observations may, it takes its place: "21 to 37", "58" and "with the tissue of its file".
struct EstimateWords {
  std::string value, interval, cause;
};
EstimateWords words_of(const Estimate& estimate);

}  // namespace coapt
