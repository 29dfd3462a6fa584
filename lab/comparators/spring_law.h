// Tension of springs and cables with its slope, which explicit methods do without.
#pragma once

#include "core/closure/model.h"

namespace coapt::comparators {

/// At one length.
struct Pull {
  double tension_n = 0.0;
  double stiffness_n_per_mm = 0.0;  ///< of the branch that the length is on
};

/// Bilinear (thesis equation 2.4).
inline Pull pull_of(const Spring& s, double length_mm) {
  const double knee = (1.0 + s.transition) * s.rest_mm;
  if (length_mm <= knee) return {s.pre_n_per_mm * (length_mm - s.rest_mm), s.pre_n_per_mm};
  return {s.pre_n_per_mm * s.transition * s.rest_mm + s.post_n_per_mm * (length_mm - knee),
          s.post_n_per_mm};
}

/// Nothing while it is slack.
inline Pull pull_of(const Cable& c, double length_mm) {
  if (length_mm <= c.rest_mm) return {};
  return {c.stiffness_n_per_mm * (length_mm - c.rest_mm), c.stiffness_n_per_mm};
}

}  // namespace coapt::comparators
