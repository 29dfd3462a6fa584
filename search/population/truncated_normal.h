// Values of a normal distribution that is cut off at both ends.
#pragma once

#include "core/metrics/mean_and_sd.h"
#include "search/population/population.h"

namespace coapt {

/// The value of the cut-off distribution at the same quantile as `standard` is of a standard normal one: so correlated normal
/// variables become correlated values (a Gaussian copula, Nelsen 2006).
double truncated_normal(const PriorDistribution& distribution, double standard);

/// The share of the cut-off distribution that lies below `value`, [0, 1]; 0.5 if its sd is 0.
double share_below(const PriorDistribution& distribution, double value);

/// Of the cut-off distribution.
MeanAndSd cut_moments(const PriorDistribution& distribution);

}  // namespace coapt
