// --plan FILE, --rank N and --ring FILE[:SIZE]: the repair that a command applies first.
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
  std::string ring;  ///< ring_option.h
};

void add_plan_option(Command command, PlanOption& option);

/// Whether there is a repair at all.
bool is_given(const PlanOption& option);

/// What errors of read_plan_option() are of.
std::string source_of(const PlanOption& option);

/// No steps if no file was named. @param valve what a ring is sized for; may be null.
Expected<RepairPlan> read_plan_option(const PlanOption& option, const Valve* valve);

struct PlannedValve {
  int failed = 0;  ///< an exit code; what is wrong was said on standard error
  Valve valve{};   ///< before
  RepairPlan plan{};
  Valve repaired{};
};

/// A command's valve (read_argument.h) with its plan applied.
PlannedValve read_planned_valve(const std::string& argument, const PlanOption& option);

}  // namespace coapt
