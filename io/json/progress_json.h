// How far a search is, as JSON.
#pragma once

#include "io/json/json.h"
#include "search/plans/search_progress.h"

namespace coapt {

/// {"stage", "closures", "closures_planned", "best_leak_mm2", "best_cost", "random_cost" (null while infinite),
/// "best" (if there is one): {"cost", "nodes", "leak_mm2", "description", "plan"}}
Json to_json(const SearchProgress& progress);

}  // namespace coapt
