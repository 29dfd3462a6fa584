// Chordae as long as in the closed, pressurised valve (thesis 2.2.2). Valves are closed for it, that is why this is not
// in core/valve.
#pragma once

#include "core/closure/closure_options.h"
#include "core/valve/parametric.h"

namespace coapt {

/// Lengths of chordae over those of the first closing, in which the leaflets hang too low: with it
/// the mid-valve section of presets tents by 6 to 8 mm.
inline constexpr double kPresetSlack = 1.15;
inline constexpr ChordalSlack kPresetSlacks = {kPresetSlack, kPresetSlack, kPresetSlack,
                                               kPresetSlack, kPresetSlack};

/// The valve with chordae as long as they are in its closed state, closed more tightly than usual. Error: it does not close
/// uncrossed, or not within the budget. @pre the valve is valid.
Expected<Valve> taut_when_closed(const Valve& valve, const ClosureBudget& budget = {});

/// A parametric valve whose chordae are taut in its closed state (times dimensions.slack, each group its own). The
/// lengths come from the mesh of about 650 triangles and are the same at every resolution. What
/// validate() would refuse is refused here, before anything is closed.
Expected<Valve> make_taut_valve(const ParametricValve& dimensions,
                                const ClosureBudget& budget = {});

}  // namespace coapt
