// What tolerances cost in accuracy: tiers of settings of method fast, each with the error of the
// leak that was measured for it.
//
// Error: leak of a closure at the tier's tolerances less that of the same closure carried on in
// double precision to residual 1e-6, on the same mesh of about 650 triangles with the same
// membrane. It is that of stopping early: neither that of the mesh nor the distance to another
// equilibrium of the same valve. The largest errors are of single scenes that end in another fold,
// or were tried again where the other was not; they hardly fall with the tolerance, so tiers are
// chosen by what 99 of 100 scenes keep. `lab/closures/tolerances` measures the table of
// accuracy.cpp again.
#pragma once

#include <vector>

#include "core/closure/closure_options.h"
#include "core/valve/types.h"

namespace coapt {

/// |Error| of the leak over kAccuracyScenes varied scenes.
struct TierError {
  double p99_mm2 = 0.0, max_mm2 = 0.0;
  double relative_time = 1.0;  ///< of whole closures, 1 at the default tolerances
};

struct AccuracyTier {
  double residual_tolerance = 0.0, way_tolerance_mm = 0.0;  ///< see ClosureOptions
  TierError springs, continuum;
};

/// 60 of each of five presets (lab/closures/tolerances.cpp).
inline constexpr int kAccuracyScenes = 300;

/// Cheapest first; errors of 99 % fall and times rise from tier to tier.
const std::vector<AccuracyTier>& accuracy_tiers();

const TierError& error_of(const AccuracyTier& tier, Membrane membrane);

/// The cheapest tier that keeps within `leak_mm2` in 99 of 100 scenes. What no tier keeps, or is
/// not a number, is an error at "/accuracy" that names the accepted range.
Expected<AccuracyTier> choose_tier(double leak_mm2, Membrane membrane);

/// `options` at a tier's tolerances.
ClosureOptions at_tier(ClosureOptions options, const AccuracyTier& tier);

}  // namespace coapt
