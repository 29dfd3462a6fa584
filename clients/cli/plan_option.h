// --plan FILE and --rank N: the repair that a command applies first.
#pragma once

#include <string>

#include "core/repair/plan.h"
#include "core/valve/problem_list.h"
#include "core/valve/valve.h"
#include "io/command_line/command_line.h"

namespace coapt {

struct PlanOption {
  std::string file;
  int rank = 1;
};

void add_plan_option(Command command, PlanOption& option);

/// No steps if no file was named.
Expected<RepairPlan> read_plan_option(const PlanOption& option);

struct PlannedValve {
  int failed = 0;  ///< an exit code; what is wrong was said on standard error
  Valve valve{};   ///< before
  RepairPlan plan{};
  Valve repaired{};
};

/// A command's valve (files.h) with its plan applied.
PlannedValve read_planned_valve(const std::string& argument, const PlanOption& option);

}  // namespace coapt
