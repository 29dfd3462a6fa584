// The porcine valve of the thesis's chapter 4, of which only answers are published, as a parametric
// valve that gives those answers. No measured anatomy.
#pragma once

#include "core/valve/parametric.h"

namespace coapt {

/// Anatomy of preset porcine-thesis-tables: fitted to figure 4.5 and table 4.1 of the thesis
/// (`coapt study calibrate`; docs/porcine-thesis.md has the fit, number by number).
ParametricValve porcine_thesis_tables();

/// Of porcine-thesis: fitted to the same and, of several such fits, the one nearest to the thesis's
/// statement on anchors (figure 4.10) by the thesis's look-up: eight of nine comparisons, the ninth
/// a tie.
ParametricValve porcine_thesis();

}  // namespace coapt
