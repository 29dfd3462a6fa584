// Closing a valve: from its unstressed shape to rest under systolic pressure, with self-contact.
#pragma once

#include "core/closure/closure_options.h"
#include "core/closure/closure_result.h"
#include "core/valve/valve.h"

namespace coapt {

class PreparedValve;

/// Deterministic: the same valve and options give the same bits, on any instruction set. Never
/// throws on a valid valve. `neighbour`: a closure of a valve with the same mesh, for a warm start
/// of method fast: from there, its annulus travelling to this valve's. What comes of it may be
/// another equilibrium than from the open state. If it does not converge uncrossed, or the
/// neighbour did not, the closure starts from the open state.
/// @pre validate(valve) is empty; the neighbour's valve has the same faces.
ClosureResult close_valve(const Valve& valve, const ClosureOptions& options = {},
                          const ClosureResult* neighbour = nullptr);

/// The same bits, without the work that a prepared valve has done. @pre It serves the valve under
/// these options (prepared_valve.h).
ClosureResult close_valve(const PreparedValve& prepared, const Valve& valve,
                          const ClosureOptions& options, const ClosureResult* neighbour = nullptr);

}  // namespace coapt
