#include "clients/cli/plan_option.h"

#include "clients/cli/exit_code.h"
#include "clients/cli/files.h"
#include "core/repair/apply_plan.h"

namespace coapt {

void add_plan_option(Command command, PlanOption& option) {
  command.add_option("--plan", option.file,
                     "Repair plan to apply first: coapt.plan/1, what plan --json prints, or the "
                     "page's saved plans");
  command.add_option("--rank", option.rank, "Which plan of a file with several")
      .check(number_from(1, 100000))
      .show_default();
}

Expected<RepairPlan> read_plan_option(const PlanOption& option) {
  if (option.file.empty()) return RepairPlan{};
  return read_plan_argument(option.file, option.rank);
}

PlannedValve read_planned_valve(const std::string& argument, const PlanOption& option) {
  Expected<Valve> valve = read_valve_argument(argument);
  if (!valve) return {.failed = report_errors(argument, valve.errors())};
  Expected<RepairPlan> plan = read_plan_option(option);
  if (!plan) return {.failed = report_errors(option.file, plan.errors())};
  Expected<Valve> repaired = apply_plan(*valve, *plan);
  if (!repaired) return {.failed = report_errors(option.file, repaired.errors())};
  return {0, *std::move(valve), *std::move(plan), *std::move(repaired)};
}

}  // namespace coapt
