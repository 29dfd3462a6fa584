// How sure a mean is.
#pragma once

#include <span>

namespace coapt {

struct MeanInterval {
  double mean = 0.0;
  double low = 0.0, high = 0.0;  ///< 95 %
  int count = 0;
};

/// Percentile interval of the mean over resamples (Efron 1979), always the same ones. NaN without values.
MeanInterval mean_interval(std::span<const double> values);

}  // namespace coapt
