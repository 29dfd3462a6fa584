#pragma once

#include <algorithm>
#include <iterator>
#include <vector>

namespace coapt {

/// Of an even number of values the upper of both in the middle. @pre there is one
inline double median(std::vector<double> values) {
  const auto middle = values.begin() + std::ssize(values) / 2;
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace coapt
