#include "clients/cli/plan_option.h"

#include "clients/cli/files.h"

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

}  // namespace coapt
