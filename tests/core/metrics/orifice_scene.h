// What the tests of both orifices share.
#pragma once

#include <vector>

#include "core/metrics/orifice.h"

namespace coapt {

/// Coordinates of a grid's lines.
inline std::vector<double> lines(double first, double step, int count) {
  std::vector<double> values;
  for (int i = 0; i < count; ++i) values.push_back(first + step * i);
  return values;
}

inline double total_mm2(const OrificeView& view) {
  double total = 0.0;
  for (const Orifice& orifice : view.orifices) total += orifice.area_mm2;
  return total;
}

}  // namespace coapt
