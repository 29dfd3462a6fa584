// Papillary tips and chordae for a valve whose images show none, drawn from anatomy.
//
// A draw takes, per muscle: three to seven marginal trunks of three insertions each, spread over its half of the free edge, one
// strut chorda and two basal ones (about 10 chordae a muscle, 3 to 18: n = 116 hearts); tips below the annulus, if they were not
// seen (23.5 mm, sd 3.8: n = 57); lengths as in the closed, pressurised state of the valve with longer ones (thesis 2.2.2), times a
// slack. Seed 0 is the mean of all draws, the pattern of parametric valves; the others are draws.
//
// Assumed, for want of sources: by how much trunks, struts and basal chordae move along the edge and the leaflet, and the spread of
// slack (the healthy preset's of the group; 5 % between valves, 3 % between chordae).
#pragma once

#include "core/closure/closure_options.h"
#include "core/valve/valve.h"

namespace coapt {

/// The valve with heads and chordae of this draw in place of its own. Tips: m x 3 in the valve's frame, x < 0 is the anterolateral
/// muscle's (parametric_chordae.h), where they are unpressurised; none: they are drawn. Lengths are taken with annulus and
/// tips at rest; by how much the old heads and the annulus move under pressure, the new ones do. The same arguments give the same bits. Errors:
/// "/tips_mm", tips of one side alone, or not 5 to 60 mm below the annulus's centre; a valve that does not close uncrossed, from
/// which no lengths can be taken, or not within the budget; what validate() refuses. @pre mesh, annulus, landmarks and tissue are valid and mitral.
Expected<Valve> with_synthetic_chordae(Valve valve, int seed, const Points& tips_mm,
                                       const ClosureBudget& budget = {});

/// Another draw of a valve that has one (Valve::drawn_chordae), its tips kept if they were seen.
Expected<Valve> redrawn_chordae(const Valve& valve, int seed, const ClosureBudget& budget = {});

}  // namespace coapt
