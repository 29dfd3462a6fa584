// Closing a valve as finely as an error needs: mesh and tolerances together.
#pragma once

#include "core/closed/closed_valve.h"
#include "core/closure/accuracy.h"

namespace coapt {

struct AccurateClosure {
  ClosedValve closed;  ///< on the last mesh
  AccuracyTier tier;   ///< the cheapest whose error is at most 0.7 of what is allowed
  int refinements = 0;
};

/// Refines the valve (core/valve/refine.h) until its leak is known to `error_mm2` or better
/// (ValveMeasure::error), each mesh from the closed state of the one before. A closure that
/// does not converge uncrossed ends it; its error is NaN. What no tier keeps, and what no mesh
/// of at most `most_vertices` keeps, is an error at "/accuracy" that names the accepted range.
/// @pre the valve is valid and mitral, the method Fast.
Expected<AccurateClosure> close_within(const Valve& valve, double error_mm2,
                                       const ClosureOptions& options, int most_vertices = 10000);

}  // namespace coapt
