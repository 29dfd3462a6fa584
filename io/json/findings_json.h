// The thesis's findings beside ours, as JSON.
#pragma once

#include <vector>

#include "io/json/json.h"
#include "search/studies/findings.h"

namespace coapt {

/// [{"finding", "section", "thesis", "ours", "judged", "agrees"}, ...]
Json to_json(const std::vector<Finding>& findings);

}  // namespace coapt
