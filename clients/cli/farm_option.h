// --farm: the work is done by the workers of a farm.
#pragma once

#include <string>

#include "farm/ask/ask.h"
#include "io/command_line/command_line.h"

namespace coapt {

/// --farm (or COAPT_FARM). @param what the farm does of the command, for its help
void add_farm_option(Command command, std::string& url, const std::string& what);

/// Whoever does the work: the farm at `url`, or this process where that is empty.
Asker asker_of(const std::string& url, int threads);

}  // namespace coapt
