// Ruptured chordae as explanations of a closed surface: for each scallop the hypothesis that the marginal chordae which insert in
// it are ruptured (ruptures.h), against the valve as given.
//
// 1. The valve as given is fitted as always ("intact"); it may take all of the time.
// 2. Screen: the valve of each hypothesis is closed at the values of that fit, at those with the lengths of chordae at their
//    priors (an intact fit makes chordae longer where they are in truth ruptured), and at the priors. The least sum of squares
//    counts: distances, leak, and how far values are from their priors.
// 3. A hypothesis could win if its screen is at most three times the intact fit's sum of squares (assumed: a screen has the lesion's
//    shape, but not its lengths). The best two of those are fitted, from their screens.
// 4. All are weighed alike, in screen and comparison: by noise and independent points of the answer that leaves the least
//    distances. By those of an intact fit that misses a flail scallop by 2 mm, everything weighs as two points. Probability ~
//    prior exp(-sum of squares / 2), the prior a half for intact, the other half shared alike by the scallops (assumed). What
//    was not fitted has its screen, which bounds its probability from below.
#pragma once

#include "search/fit/fit.h"

namespace coapt {

/// The valve of the most probable hypothesis, `before` the valve as given. Deterministic, for any number of threads. Errors: those of
/// fit_valve().
/// @pre the valve is valid and mitral.
Expected<ValveFit> fit_with_ruptures(const Valve& valve, const MeasuredClosure& measured,
                                     FitOptions options);

}  // namespace coapt
