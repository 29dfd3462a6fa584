// The map of stability, and its table.
#pragma once

#include <string>
#include <vector>

#include "search/stability_study.h"

namespace coapt {

/// Columns: scene, axis, level, nominal, method, outcome, steps, seconds, residual, crossing_pairs,
/// attempts, from_reference_mm, end_from_reference_mm, orifice_difference_mm2. Empty where there is no
/// number.
std::string stability_csv(const std::vector<StabilityCell>& cells);

/// A panel a scene and axis, a row a method, a column a level (nominal framed); an outcome is a colour
/// and a letter.
std::string stability_svg(const std::vector<StabilityCell>& cells);

}  // namespace coapt
