// A number with what is known of how far it may be off, apart by cause.
//
// Each part is an interval of the number itself from 5 to 95 %, given that the other causes leave it as it is; skewed where its cause is, and
// none where nothing is known of it. The parts are not added: they say different things, and the widest is the one to look at.
#pragma once

#include <limits>
#include <optional>
#include <vector>

namespace coapt {

/// From 5 to 95 %.
struct Interval {
  double low = 0.0, high = 0.0;

  bool operator==(const Interval&) const = default;
};

enum class ErrorCause {
  Numerical,  ///< mesh, stopping early, other ends of the closure
  Tissue,     ///< draws of what the model does not know of the valve
  Execution   ///< the hand: the region about a plan
};

struct Estimate {
  double value = std::numeric_limits<double>::quiet_NaN();
  std::optional<Interval> numerical{}, tissue{}, execution{};
};

const char* to_string(ErrorCause cause);  ///< "numerical", "tissue", "execution"

const std::optional<Interval>& part_of(const Estimate& estimate, ErrorCause cause);

/// In other units, so many to one of its own.
Estimate scaled(Estimate estimate, double units);

/// Of the interval of widest(); NaN if nothing is known.
double half_width(const Estimate& estimate);

/// The tissue's interval and that of the computation (or the value) have no value in common: observations contradict the tissue of the file.
bool tissue_excludes_value(const Estimate& estimate);

/// The cause of the widest known interval, the first of equal ones, but the tissue where it excludes the value; none if nothing is known.
std::optional<ErrorCause> widest(const Estimate& estimate);

/// Of an area, which is not below 0, with an error that nine of ten keep; none if either is not finite.
std::optional<Interval> area_interval(double area_mm2, double error_mm2);

/// Of samples, each with its weight >= 0 (empty: all alike); none of fewer than five that have one.
std::optional<Interval> sampled_interval(const std::vector<double>& values,
                                         const std::vector<double>& weights = {});

}  // namespace coapt
