// Work of kind "orifices": the orifices of one valve's configurations, 17 bytes each.
//
// The first part: {"valve": part, "closure": options, "keys": [[9 integers], ...]}. An item is a key; its answer two doubles,
// area and sd, and a byte, trusted: what OrificeTable::at() gives, bit for bit.
#pragma once

#include <string_view>
#include <vector>

#include "farm/work/orifice_tables.h"
#include "farm/work/work.h"
#include "search/studies/orifice_table.h"

namespace coapt {

/// Errors: closure options that cannot be sent (closure_options_json.h).
Expected<WorkRequest> orifice_request(const Valve& valve, const ClosureOptions& closure,
                                      const std::vector<ConfigurationKey>& keys);

/// With `tables`, which may be null, it shares what it closes with other works of its valve.
Expected<Work> open_orifice_work(const WorkRequest& request, OrificeTables* tables = nullptr);

/// In the order of the keys. Errors: not as many bytes as `count` answers have.
Expected<std::vector<OrificeSample>> orifice_answers(std::string_view bytes, std::size_t count);

}  // namespace coapt
