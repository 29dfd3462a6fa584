#pragma once

#include <memory>
#include <string>

#include "io/command_line/command_line.h"
#include "io/store/plan_store.h"
#include "search/plans/plan_search.h"

namespace coapt {

/// --store: closures kept in a file as they are made. A run that was killed, run again, takes those first.
void add_store_option(Command command, std::string& path);

/// Opens the store (none if the path is empty) and lets `context` read from it and keep in it. A closure that
/// cannot be kept throws (std::runtime_error): for main(). Errors: the file cannot be used.
Expected<std::shared_ptr<PlanStore>> use_store(const std::string& path, const Valve& valve,
                                               const ClosureOptions& closure,
                                               SearchContext& context);

/// kBadInput for a file of another kind, kFailure for one that cannot be used now.
int report_store_errors(const std::string& command, const Errors& errors);

}  // namespace coapt
