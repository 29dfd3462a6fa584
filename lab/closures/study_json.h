// Studies of closures, as JSON.
#pragma once

#include <nlohmann/json.hpp>

#include "lab/closures/closure_study.h"

namespace coapt {

/// Keys that scripts rely on: closures_per_second_per_core, median_ms, unconverged, crossed,
/// other_equilibria.
nlohmann::ordered_json to_json(const ClosureStudyOptions& options, const ClosureStudy& study);

}  // namespace coapt
