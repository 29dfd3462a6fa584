// Studies of closures, as JSON.
#pragma once

#include "core/closure/accuracy.h"
#include "io/json/json.h"
#include "lab/closures/closure_study.h"

namespace coapt {

/// Keys that scripts rely on: closures_per_second_per_core, median_ms, unconverged, crossed,
/// other_equilibria.
Json to_json(const ClosureStudyOptions& options, const ClosureStudy& study);

/// {"residual_tolerance", "way_tolerance_mm", "leak_error_p99_mm2", "leak_error_max_mm2",
/// "scenes", "of"}: the tolerances of a tier and the errors that were measured for them.
Json to_json(const AccuracyTier& tier, Membrane membrane);

}  // namespace coapt
