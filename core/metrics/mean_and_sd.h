#pragma once

#include <cmath>
#include <limits>
#include <vector>

namespace coapt {

struct MeanAndSd {
  double mean = std::numeric_limits<double>::quiet_NaN();  ///< NaN of an empty list
  double sd = std::numeric_limits<double>::quiet_NaN();    ///< of a sample (n - 1); NaN below two
};

inline MeanAndSd mean_and_sd(const std::vector<double>& values) {
  MeanAndSd found;
  if (values.empty()) return found;
  const auto count = static_cast<double>(values.size());
  double sum = 0.0, squares = 0.0;
  for (const double value : values) sum += value;
  found.mean = sum / count;
  for (const double value : values) squares += std::pow(value - found.mean, 2);
  if (values.size() > 1) found.sd = std::sqrt(squares / (count - 1.0));
  return found;
}

}  // namespace coapt
