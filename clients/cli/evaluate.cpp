#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "clients/cli/commands.h"
#include "clients/cli/exit_code.h"
#include "clients/cli/files.h"
#include "clients/cli/interrupt.h"
#include "clients/cli/plan_store_option.h"
#include "clients/cli/print.h"
#include "clients/cli/progress_bar.h"
#include "io/json/plan_json.h"
#include "io/json/plans_json.h"

namespace coapt {
namespace {

struct Arguments {
  std::string valve, store;
  std::vector<std::string> plans;
  SearchOptions options;
  bool json = false, no_evidence = false;
};

/// Reads every plan; returns an exit code.
int read_plans(const std::vector<std::string>& files, std::vector<NamedPlan>& plans) {
  int status = exit_code::kOk;
  for (const std::string& file : files) {
    const Expected<RepairPlan> plan = read_plan_argument(file);
    if (plan) {
      plans.push_back({file, *plan});
    } else {
      status = report_errors(file, plan.errors());
    }
  }
  return status;
}

/// Each error with the file of its plan.
int report_plan_errors(const std::vector<NamedPlan>& plans, const Errors& errors) {
  for (Error error : errors) {
    std::string source = "evaluate";
    for (std::size_t i = 0; i < plans.size(); ++i) {
      const std::string path = "/plans/" + std::to_string(i) + "/";
      if (!error.path.starts_with(path)) continue;
      source = plans[i].name;
      error.path.erase(0, path.size() - 1);
      break;
    }
    report_errors(source, {error});
  }
  return exit_code::kBadInput;
}

int run(Arguments arguments) {
  const std::atomic<bool>& interrupted = catch_interrupts();
  const Expected<Valve> valve = read_valve_argument(arguments.valve);
  if (!valve) return report_errors(arguments.valve, valve.errors());
  std::vector<NamedPlan> plans;
  if (const int failed = read_plans(arguments.plans, plans)) return failed;
  arguments.options.evidence = !arguments.no_evidence;
  SearchContext context{.catalogue = ring_catalogue(), .cancelled = &interrupted};
  const auto store = use_store(arguments.store, *valve, arguments.options.closure, context);
  if (!store) return report_store_errors("evaluate", store.errors());
  const auto evaluate = [&] {
    const ProgressBar bar;
    context.progress = [&](const SearchProgress& progress) { bar.show(progress); };
    return evaluate_plans(*valve, plans, arguments.options, context);
  };
  const Expected<SearchResult> result = evaluate();
  if (!result) return report_plan_errors(plans, result.errors());
  if (arguments.json) {
    nlohmann::ordered_json json = to_json(*result);
    for (nlohmann::ordered_json& plan : json["plans"]) plan["file"] = plan["name"];
    std::cout << json.dump(2) << '\n';
  } else {
    print_ranked(std::cout, *result);
  }
  return exit_code_of(*result);
}

}  // namespace

void add_evaluate(CLI::App& parent, int& status) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* command = parent.add_subcommand("evaluate", "Score and rank plans of your own");
  command->add_option("valve", arguments->valve, kValveHelp)->required();
  command->add_option("plan", arguments->plans, "Repair plans (coapt.plan/1)")->required();
  add_region_options(*command, arguments->options);
  add_store_option(*command, arguments->store);
  command->add_flag("--no-evidence", arguments->no_evidence,
                    "Leave out errors of single sutures and further remodelling");
  command->add_flag("--json", arguments->json,
                    "Print JSON, as coapt plan does, with each \"file\"");
  command->footer(
      "Example:\n"
      "  coapt evaluate human-functional-mr ring.json ring-and-suture.json");
  command->callback([arguments, &status] { status = run(*arguments); });
}

}  // namespace coapt
