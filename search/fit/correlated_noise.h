// How large residuals are, and how many of them are independent.
#pragma once

#include <vector>

#include "core/valve/types.h"

namespace coapt {

struct CorrelatedNoise {
  double sd_mm = 0.0;        ///< root mean square
  double independent = 0.0;  ///< number of points without correlation that say as much about a mean
};

/// Autocorrelation by distance between points, in bins of 1 mm up to where it is first not positive; the number of
/// independent points is n^2 over the sum of all pairs' correlations. @pre as many points as residuals, at least one.
CorrelatedNoise correlated_noise(const Points& points_mm, const std::vector<double>& residuals_mm);

}  // namespace coapt
