// Options of the command line that are rows of search_option_table.h.
#pragma once

#include <string>

#include "io/command_line/command_line.h"
#include "search/plans/search_option_table.h"

namespace coapt {

/// "--no-improvement" of "no_improvement"; a unit is left out.
std::string flag_of(const OptionRow<SearchOptions>& row);

/// Adds the option of the row of that name, with its range, help and default. @pre a number.
void add_search_option(Command command, const std::string& name, SearchOptions& options);

}  // namespace coapt
