// Chordae lengths from the closed, pressurised valve (thesis 2.2.2).
#pragma once

#include "core/closure/closure_result.h"
#include "core/valve/valve.h"

namespace coapt {

/// The valve with every chorda segment as long as its distance in the closed state times `slack`
/// (1: just taut). Ruptured chordae keep their lengths.
Valve tauten(const Valve& valve, const ClosureResult& closed, double slack);

}  // namespace coapt
