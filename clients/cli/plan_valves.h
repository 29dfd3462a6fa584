// coapt plan by requests: of several valves, or asked of a farm.
#pragma once

#include "clients/cli/plan_arguments.h"

namespace coapt {

/// What an answer holds is what a search here gives, but for "seconds", which is null. One valve is printed as ever. Several
/// leave files in the directory of -o: of each NAME.json (coapt.plans/2) and NAME.html, and summary.csv. Returns an exit code.
int plan_by_request(const Command& command, PlanArguments arguments);

/// Prints coapt.plans/2; returns an exit code.
int show_plans(const PlanArguments& arguments, Json result);

}  // namespace coapt
