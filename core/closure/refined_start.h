// From a closure of a valve to a start for the closure of the same valve on a finer mesh.
#pragma once

#include "core/closure/closure_result.h"
#include "core/valve/valve.h"

namespace coapt {

/// A neighbour for close_valve() on refine(valve): the closed shape with its edges cut in half (the
/// same polyhedron: what does not cross does not cross on it), branch points where they are, guards
/// on the parts of the guarded faces. It is the end of no closure: nothing but a start.
/// @param closed a closure of `valve`.
ClosureResult refined_start(const Valve& valve, const ClosureResult& closed);

}  // namespace coapt
