#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "clients/cli/commands.h"
#include "clients/cli/exit_code.h"
#include "clients/cli/files.h"
#include "clients/cli/print.h"
#include "core/repair/apply_plan.h"
#include "io/json/plan_json.h"
#include "io/json/result_json.h"
#include "search/objective.h"
#include "search/rank.h"

namespace coapt {
namespace {

struct Arguments {
  std::string valve;
  std::vector<std::string> plans;
  SearchOptions options;
  bool json = false;
};

struct NamedPlan {
  std::string file;
  RepairPlan plan;
  Valve repaired;
};

/// Reads every plan and applies it; returns an exit code.
int read_plans(const Valve& valve, const std::vector<std::string>& files,
               std::vector<NamedPlan>& plans) {
  int status = exit_code::kOk;
  for (const std::string& file : files) {
    const Expected<RepairPlan> plan = read_plan_argument(file);
    if (!plan) {
      status = report_errors(file, plan.errors());
      continue;
    }
    const Expected<Valve> repaired = apply_plan(valve, *plan, ring_catalogue());
    if (repaired) {
      plans.push_back({file, *plan, *repaired});
    } else {
      status = report_errors(file, repaired.errors());
    }
  }
  return status;
}

/// Ranked as the finalists of a search are, over the same region.
SearchResult score(const Valve& valve, const std::vector<NamedPlan>& plans,
                   const SearchOptions& options) {
  const Evaluator evaluate = closing_evaluator(options.closure);
  const std::function<void(const SearchProgress&)> no_progress;
  Watch watch(options.seconds, nullptr, no_progress);
  const Evaluation before = evaluate(valve);
  watch.closed(before, false);
  std::vector<Trial> trials;
  for (const NamedPlan& named : plans) {
    Trial trial{.plan = named.plan, .evaluation = evaluate(named.repaired)};
    watch.closed(trial.evaluation, true);
    trial.cost = cost(trial.evaluation, effort(valve, named.repaired, named.plan),
                      valve.tissue.thickness_mm, before.measure.tension_max_n);
    trials.push_back(trial);
  }
  const RankRequest request{evaluate, valve, options, ring_catalogue(), before};
  SearchResult result;
  result.before = before.measure;
  result.before_status = before.status;
  result.before_crossing = before.crossing;
  result.plans = rank_plans(request, trials, watch);
  result.closures = watch.closures();
  result.evaluations = static_cast<int>(trials.size());
  result.closures_not_converged = watch.not_converged();
  result.closures_crossed = watch.crossed();
  result.seconds = watch.seconds();
  return result;
}

/// The first file that holds this plan.
std::string file_of(const RepairPlan& plan, const std::vector<NamedPlan>& plans) {
  const nlohmann::ordered_json wanted = to_json(plan);
  for (const NamedPlan& named : plans) {
    if (to_json(named.plan) == wanted) return named.file;
  }
  return "";
}

void print_json(const SearchResult& result, const std::vector<NamedPlan>& plans) {
  nlohmann::ordered_json json = to_json(result);
  for (std::size_t i = 0; i < result.plans.size(); ++i) {
    json["plans"][i]["file"] = file_of(result.plans[i].plan, plans);
  }
  std::cout << json.dump(2) << '\n';
}

void print_words(SearchResult result, const std::vector<NamedPlan>& plans) {
  for (RankedPlan& ranked : result.plans) {
    ranked.description.insert(ranked.description.begin(), file_of(ranked.plan, plans));
  }
  print_ranked(std::cout, result);
}

int run(Arguments arguments) {
  const Expected<Valve> valve = read_valve_argument(arguments.valve);
  if (!valve) return report_errors(arguments.valve, valve.errors());
  std::vector<NamedPlan> plans;
  if (const int failed = read_plans(*valve, arguments.plans, plans)) return failed;
  arguments.options.plans = static_cast<int>(plans.size());
  const SearchResult result = score(*valve, plans, arguments.options);
  if (arguments.json) {
    print_json(result, plans);
  } else {
    print_words(result, plans);
  }
  return exit_code_of(result);
}

}  // namespace

void add_evaluate(CLI::App& parent, int& status) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* command = parent.add_subcommand("evaluate", "Score and rank plans of your own");
  command->add_option("valve", arguments->valve, kValveHelp)->required();
  command->add_option("plan", arguments->plans, "Repair plans (coapt.plan/1)")->required();
  add_region_options(*command, arguments->options);
  command->add_flag("--json", arguments->json,
                    "Print JSON, as coapt plan does, with each \"file\"");
  command->footer(
      "Example:\n"
      "  coapt evaluate human-functional-mr ring.json ring-and-suture.json");
  command->callback([arguments, &status] { status = run(*arguments); });
}

}  // namespace coapt
