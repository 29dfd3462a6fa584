// What the commands share: which database, and how trouble is told.
#pragma once

#include <string>

#include "farm/database/farm_database.h"
#include "io/command_line/command_line.h"

namespace coapt {

inline constexpr int kHoles = 4;  ///< exit code: some tasks of a run could not be answered

struct FarmOption {
  std::string url;
};

/// --db, or COAPT_FARM.
void add_farm_option(Command command, FarmOption& option);

/// The number of a run, as an argument.
void add_run_argument(Command command, std::uint64_t& run);

/// --recompute; untouched if it is not given.
void add_recompute_option(Command command, int& tasks);

/// A line on standard error.
void say(const std::string& message);

/// Tells each error on standard error, by say() or as {"error": {"code", "path", "message"}}; returns an exit code: kBadInput
/// for what is not there or not understood, else kFailure.
int report_farm_errors(const Errors& errors, bool json = false);

}  // namespace coapt
