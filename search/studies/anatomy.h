// The anatomy of a parametric valve as a point in a box: what calibration fits and what scans draw.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/valve/parametric.h"

namespace coapt {

/// Bounds: porcine valves as large as the thesis's first three (table 2.2), leaflets and chordae
/// within what is measured in human and porcine hearts (docs/porcine-thesis.md gives the sources).
struct AnatomyParameter {
  const char* name;  ///< with its unit
  double lower, upper, typical;
};
inline constexpr int kAnatomyParameters = 26;
const std::array<AnatomyParameter, kAnatomyParameters>& anatomy_parameters();

/// Values of the parameters, in their order.
using Anatomy = std::array<double, kAnatomyParameters>;

Anatomy typical_anatomy();
/// From shares of the ranges, each in [0, 1].
Anatomy anatomy_at(const std::vector<double>& shares);

ParametricValve parametric_valve(const Anatomy& anatomy, const std::string& name);

}  // namespace coapt
