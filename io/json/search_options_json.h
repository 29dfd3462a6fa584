// The "search" object of a request (io/schema/search.schema.json): SearchOptions without how a valve is
// closed.
#pragma once

#include "io/json/json.h"
#include "io/json/json_reader.h"
#include "search/plans/search_options.h"

namespace coapt {

/// Fields named and by default as in SearchOptions, none of them required; unknown ones are errors. How a
/// valve is closed is not asked: a request could make each closure a thousand times as long, on top of
/// their number. What the valve does not allow is check_rules()'s to say.
Expected<SearchOptions> search_options_from_json(const Json& json);

/// For JsonField::read: the "weights" of such an object.
CostWeights read_cost_weights(const JsonPlace& place);

/// Every field of it, as the above reads it.
Json to_json(const SearchOptions& options);

Json to_json(const CostWeights& weights);

}  // namespace coapt
