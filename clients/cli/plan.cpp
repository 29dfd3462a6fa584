#include <cassert>
#include <cstdint>
#include <iostream>
#include <limits>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include "clients/cli/commands.h"
#include "clients/cli/exit_code.h"
#include "clients/cli/files.h"
#include "clients/cli/interrupt.h"
#include "clients/cli/number_option.h"
#include "clients/cli/print.h"
#include "clients/cli/progress_bar.h"
#include "core/repair/apply_plan.h"
#include "io/json/plan_json.h"
#include "io/json/result_json.h"
#include "io/picture/picture.h"

namespace coapt {
namespace {

struct Arguments {
  std::string valve, report;
  SearchOptions options;
  bool json = false;
};

ClosedValve close_for_picture(const Valve& valve, const ClosureOptions& options) {
  const ClosureResult closure = close_valve(valve, options);
  return {valve, closure, measure(valve, closure)};
}

/// What gives the same plans again; threads and time limit change nothing but the time it takes.
std::string command_line(const Arguments& arguments) {
  std::ostringstream line;
  line << "coapt plan " << arguments.valve << " --evaluations " << arguments.options.evaluations
       << " --seed " << arguments.options.seed << " --plans " << arguments.options.plans
       << " --region-points " << arguments.options.region_points;
  return line.str();
}

std::string report_html(const Valve& valve, const SearchResult& result,
                        const Arguments& arguments) {
  const ClosureOptions& options = arguments.options.closure;
  std::vector<ClosedValve> after;
  for (const RankedPlan& ranked : result.plans) {
    const Expected<Valve> repaired = apply_plan(valve, ranked.plan, ring_catalogue());
    assert(repaired && "the search only ranks plans that can be applied");
    after.push_back(close_for_picture(*repaired, options));
  }
  return plan_report_html(close_for_picture(valve, options), after, result,
                          command_line(arguments));
}

int run(const Arguments& arguments) {
  const std::atomic<bool>& interrupted = catch_interrupts();
  const Expected<Valve> valve = read_valve_argument(arguments.valve);
  if (!valve) return report_errors(arguments.valve, valve.errors());
  if (const int failed = check_output(arguments.report)) return failed;

  const auto search = [&] {
    const ProgressBar bar;
    return search_plans(
        *valve, arguments.options, ring_catalogue(),
        [&](const SearchProgress& progress) { bar.show(progress); }, &interrupted);
  };
  const Expected<SearchResult> result = search();
  if (!result) return report_option_errors("plan", result.errors());

  if (arguments.json) {
    std::cout << to_json(*result).dump(2) << '\n';
  } else {
    print_ranked(std::cout, *result);
  }
  if (!arguments.report.empty()) {
    const std::string report = report_html(*valve, *result, arguments);
    if (const int failed = write_output(arguments.report, report)) return failed;
  }
  return exit_code_of(*result);
}

}  // namespace

void add_plan(CLI::App& parent, int& status) {
  const auto arguments = std::make_shared<Arguments>();
  SearchOptions& options = arguments->options;
  CLI::App* command = parent.add_subcommand("plan", "Search repair plans and rank them");
  command->add_option("valve", arguments->valve, kValveHelp)->required();
  command
      ->add_option("--evaluations", options.evaluations,
                   "Closures spent on searching; ranking comes on top, see below")
      ->check(number_from(1, 1000000))
      ->capture_default_str();
  command->add_option("--seed", options.seed, "Same seed, same plans")
      ->check(number_from(std::uint64_t{0}, std::numeric_limits<std::uint64_t>::max()))
      ->capture_default_str();
  command->add_option("--seconds", options.seconds, "Stop after this time; 0: no limit")
      ->check(number_from(0.0, 1e6))
      ->capture_default_str();
  command->add_option("--plans", options.plans, "How many ranked plans to print")
      ->check(number_from(1, 50))
      ->capture_default_str();
  add_region_options(*command, options);
  command->add_flag("--json", arguments->json, "Print JSON");
  command->add_option("-o,--report", arguments->report, "Write a report with pictures (HTML)")
      ->check(CLI::Validator(refuse_standard_output, "FILE"));
  command->footer(
      "Closures in all: 1 of the valve as it is, --evaluations on searching, and then for the "
      "ranking\n"
      "4 for each of twice --plans finalists and --region-points - 5 for each of the best --plans: "
      "at\n"
      "most 1 + 300 + 100 by default. A report closes the valve and each ranked plan once more.\n\n"
      "Ctrl-C stops the search and prints the best so far (exit code 130) when the closures in\n"
      "progress have ended. A second one ends coapt at once (130 in the shell): nothing is "
      "printed.\n\n"
      "Exit code 4 unless the best plan closes the valve robustly: all closures over its region\n"
      "converge without crossing, and mean + sd of the leak stay below 1 mm2.\n\n"
      "Examples:\n"
      "  coapt plan human-functional-mr --evaluations 300 --seed 1\n"
      "  coapt plan valve.json --plans 10 --json -o report.html > plans.json");
  command->callback([arguments, &status] { status = run(*arguments); });
}

}  // namespace coapt
