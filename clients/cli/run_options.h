// Options that studies, fits and designs share.
#pragma once

#include <cstdint>
#include <string>

#include "io/command_line/command_line.h"

namespace coapt {

/// --threads, which is shown with its default.
void add_threads_option(Command command, int& threads);

/// --seed, from 0 to 2^62. @param what it seeds, for its help
void add_seed_option(Command command, std::uint64_t& seed, const std::string& what);

}  // namespace coapt
