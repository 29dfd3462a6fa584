// A search's plans as a table: CSV with a header line, numbers with six digits, empty where there is none.
#pragma once

#include <string>

#include "core/valve/valve.h"
#include "search/plans/search_result.h"

namespace coapt {

/// Every plan that was closed, a row each in the order of trying; the plan itself, coapt.plan/1, last.
std::string tried_plans_csv(const Valve& valve, const SearchResult& result);

}  // namespace coapt
