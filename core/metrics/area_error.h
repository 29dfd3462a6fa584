// How far an area of a closure may be off, for the numerics alone: mesh (with the other equilibria
// that another mesh may find) and stopping early. What the model of the tissue does to it is
// another matter.
//
// Measured against 5,200 and 10,400 triangles over varied scenes of presets and of random
// anatomies, springs and continuum alike; half of the valves were kept aside and judged by the
// other half's numbers (docs/researcher/accuracy.md, lab/closures/area_error_table.py).
#pragma once

#include "core/closure/closure_result.h"
#include "core/valve/valve.h"

namespace coapt {

/// What the error of a closure's areas depends on.
struct AreaPrecision {
  int triangles = 0;  ///< of the leaflets, >= 1
  Membrane membrane = ClosureOptions{}.membrane;
  double residual_tolerance = ClosureOptions{}.residual_tolerance;
  double way_tolerance_mm = ClosureOptions{}.way_tolerance_mm;
};

AreaPrecision precision_of(const Valve& valve, const ClosureResult& closure);

/// Error of a leak of `area_mm2` >= 0 that nine of ten scenes keep: the root of the
/// sum of the squares of (0.7 mm2 + 0.65 mm sqrt(area)) (650 / triangles)^0.6, an opening's error
/// being that of its rim, and of what the tolerances leave (core/closure/accuracy.h). Measured on
/// mitral valves of 325 to 5,200 triangles.
double area_error_mm2(double area_mm2, const AreaPrecision& precision);

/// Standard deviations that this error is, where it is taken as normal.
inline constexpr double kAreaErrorSds = 1.645;

}  // namespace coapt
