// Chordae as long as in the closed, pressurised valve (thesis 2.2.2). Valves are closed for it, that is why this is not
// in core/valve.
#pragma once

#include "core/closure/closure_options.h"
#include "core/valve/parametric.h"

namespace coapt {

/// The valve with chordae as long as they are in its closed state, closed more tightly than usual. Error: it does not close
/// uncrossed, or not within the budget. @pre the valve is valid.
Expected<Valve> taut_when_closed(const Valve& valve, const ClosureBudget& budget = {});

/// Length of a chorda over its length in the closed, pressurised valve, by the group that it is of.
double slack_of(const ChordalSlack& slack, const Valve& valve, const Chorda& chorda);

/// A parametric valve whose chordae are taut in its closed state (times dimensions.slack, each group its own). The
/// lengths come from the mesh of about 650 triangles and are the same at every resolution. What
/// validate() would refuse is refused here, before anything is closed.
Expected<Valve> make_taut_valve(const ParametricValve& dimensions,
                                const ClosureBudget& budget = {});

}  // namespace coapt
