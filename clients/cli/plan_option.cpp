#include "clients/cli/plan_option.h"

#include "clients/cli/read_argument.h"
#include "clients/cli/ring_option.h"
#include "core/repair/apply_plan.h"
#include "io/command_line/files.h"

namespace coapt {

void add_plan_option(Command command, PlanOption& option) {
  command.add_option("--plan", option.file,
                     "Repair plan to apply first: a coapt.plan/1 file, the output of coapt plan "
                     "--json, or plans saved on the page");
  command.add_option("--rank", option.rank, "Rank of the plan to use in a file with several plans")
      .check(number_from(1, 100000))
      .show_default();
  command.add_option("--ring", option.ring, kRingHelp).show_argument("FILE[:SIZE]");
}

bool is_given(const PlanOption& option) { return !option.file.empty() || !option.ring.empty(); }

std::string source_of(const PlanOption& option) {
  return option.file.empty() ? option.ring : option.file;
}

Expected<RepairPlan> read_plan_option(const PlanOption& option, const Valve* valve) {
  RepairPlan plan;
  if (!option.file.empty()) {
    Expected<RepairPlan> read = read_plan_argument(option.file, option.rank);
    if (!read) return read.errors();
    plan = *std::move(read);
  }
  if (option.ring.empty()) return plan;
  const Expected<RepairStep> ring = read_ring_step(option.ring, valve);
  if (!ring) return ring.errors();
  plan.steps.push_back(*ring);
  return plan;
}

PlannedValve read_planned_valve(const std::string& argument, const PlanOption& option) {
  Expected<Valve> valve = read_valve_argument(argument);
  if (!valve) return {.failed = report_errors(argument, valve.errors())};
  Expected<RepairPlan> plan = read_plan_option(option, &*valve);
  if (!plan) return {.failed = report_errors(source_of(option), plan.errors())};
  Expected<Valve> repaired = apply_plan(*valve, *plan);
  if (!repaired) return {.failed = report_errors(source_of(option), repaired.errors())};
  return {0, *std::move(valve), *std::move(plan), *std::move(repaired)};
}

}  // namespace coapt
