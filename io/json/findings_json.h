// The thesis's findings beside ours, as JSON.
#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "search/studies/findings.h"

namespace coapt {

/// [{"finding", "section", "thesis", "ours", "judged", "agrees"}, ...]
nlohmann::ordered_json to_json(const std::vector<Finding>& findings);

}  // namespace coapt
