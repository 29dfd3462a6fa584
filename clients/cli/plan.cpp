#include <algorithm>
#include <cctype>
#include <cstdint>
#include <cstring>
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
#include "clients/cli/plan_store_option.h"
#include "clients/cli/print.h"
#include "clients/cli/progress_bar.h"
#include "io/json/json_reader.h"
#include "io/json/plan_json.h"
#include "io/json/plans_json.h"
#include "io/json/search_options_json.h"
#include "io/json/valve_json.h"
#include "io/picture/report.h"
#include "io/store/subject.h"

namespace coapt {
namespace {

struct Arguments {
  std::string valve, report, search, fixed, store;
  SearchOptions options;
  std::vector<std::string> forbidden;
  bool json = false, no_evidence = false;
};

/// For a shell.
std::string quoted(const std::string& word) {
  const bool plain = std::all_of(word.begin(), word.end(), [](unsigned char c) {
    return std::isalnum(c) != 0 || std::strchr("-_./:,+", c) != nullptr;
  });
  if (plain && !word.empty()) return word;
  std::string text = "'";
  for (const char letter : word) text += letter == '\'' ? "'\\''" : std::string(1, letter);
  return text + '\'';
}

/// What gives the same plans again, unless the search was cancelled or out of time; threads and store
/// change nothing but the time it takes.
std::string command_line(const Arguments& arguments) {
  const SearchOptions& options = arguments.options;
  std::ostringstream line;
  line.precision(17);
  line << "coapt plan " << quoted(arguments.valve);
  if (!arguments.search.empty()) line << " --search " << quoted(arguments.search);
  line << " --evaluations " << options.evaluations << " --seed " << options.seed << " --plans "
       << options.plans << " --region-points " << options.region_points;
  if (!arguments.fixed.empty()) line << " --fix " << quoted(arguments.fixed);
  for (const std::string& word : arguments.forbidden) line << " --forbid " << word;
  if (options.no_improvement > 0) line << " --no-improvement " << options.no_improvement;
  if (options.target_mm2 >= 0.0) line << " --target " << options.target_mm2;
  if (!options.evidence) line << " --no-evidence";
  return line.str();
}

std::string report_html(const Valve& valve, const SearchResult& result,
                        const SearchRequest& request) {
  const PlanPictures pictures = close_for_report(valve, result, request.options.closure);
  return plan_report_html({pictures.before, pictures.after, result, request});
}

/// The search object of a file, with what the command line says in its place.
int complete_options(const CLI::App& command, Arguments& arguments) {
  SearchOptions& given = arguments.options;
  if (!arguments.search.empty()) {
    const Expected<std::string> text = read_input(arguments.search);
    if (!text) return report_errors(arguments.search, text.errors());
    const Expected<nlohmann::json> json = parse_json(*text);
    if (!json) return report_errors(arguments.search, json.errors());
    Expected<SearchOptions> read = search_options_from_json(*json);
    if (!read) return report_errors(arguments.search, read.errors());
    const auto keep = [&](const char* name, auto member) {
      if (command.count(name) > 0) (*read).*member = given.*member;
    };
    keep("--evaluations", &SearchOptions::evaluations);
    keep("--seed", &SearchOptions::seed);
    keep("--threads", &SearchOptions::threads);
    keep("--seconds", &SearchOptions::seconds);
    keep("--plans", &SearchOptions::plans);
    keep("--region-points", &SearchOptions::region_points);
    keep("--no-improvement", &SearchOptions::no_improvement);
    keep("--target", &SearchOptions::target_mm2);
    given = *read;
  }
  if (arguments.no_evidence) given.evidence = false;
  for (const std::string& word : arguments.forbidden) given.rules.forbidden.push_back(word);
  if (!arguments.fixed.empty()) {
    const Expected<RepairPlan> fixed = read_plan_argument(arguments.fixed);
    if (!fixed) return report_errors(arguments.fixed, fixed.errors());
    given.rules.fixed = *fixed;
  }
  return exit_code::kOk;
}

/// Each with the option or the file that it comes from.
int report_search_errors(const Arguments& arguments, const Errors& errors) {
  const std::string fixed = "/rules/fixed", forbidden = "/rules/forbidden";
  for (Error error : errors) {
    if (!arguments.fixed.empty() && error.path.starts_with(fixed)) {
      error.path.replace(0, fixed.size(), "--fix");
    } else if (!arguments.forbidden.empty() && error.path.starts_with(forbidden)) {
      error.path.replace(0, forbidden.size(), "--forbid");
    } else if (!arguments.search.empty()) {
      report_errors(arguments.search, {error});
      continue;
    } else if (error.path == "/rules") {
      error.path.clear();
    } else {
      report_option_errors("plan", {error}, {{"/target_mm2", "--target"}});
      continue;
    }
    report_errors("plan", {error});
  }
  return exit_code::kBadInput;
}

int run(const CLI::App& command, Arguments arguments) {
  const std::atomic<bool>& interrupted = catch_interrupts();
  const Expected<Valve> valve = read_valve_argument(arguments.valve);
  if (!valve) return report_errors(arguments.valve, valve.errors());
  if (const int failed = complete_options(command, arguments)) return failed;
  if (const int failed = check_output(arguments.report)) return failed;
  const SearchOptions& options = arguments.options;
  SearchContext context{.catalogue = ring_catalogue(), .cancelled = &interrupted};
  const auto store = use_store(arguments.store, *valve, options.closure, context);
  if (!store) return report_store_errors("plan", store.errors());

  const auto search = [&] {
    const ProgressBar bar;
    context.progress = [&](const SearchProgress& progress) { bar.show(progress); };
    return search_plans(*valve, options, context);
  };
  const Expected<SearchResult> result = search();
  if (!result) return report_search_errors(arguments, result.errors());

  const SearchRequest request{options, subject_of(*valve, options.closure),
                              command_line(arguments)};
  if (arguments.json) {
    std::cout << to_json(*result, request).dump(2) << '\n';
  } else {
    print_ranked(std::cout, *result);
  }
  if (!arguments.report.empty()) {
    const std::string report = report_html(*valve, *result, request);
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
  command
      ->add_option("--no-improvement", options.no_improvement,
                   "Stop searching after so many closures without a better plan; 0: never")
      ->check(number_from(0, 1000000));
  command
      ->add_option("--target", options.target_mm2,
                   "Stop searching when mean + sd of a plan's leak is not above this (mm2)")
      ->check(number_from(0.0, 1e6));
  command->add_option("--fix", arguments->fixed, "A plan whose steps every plan has");
  command
      ->add_option("--forbid", arguments->forbidden,
                   "What no plan has: annuloplasty, papillary_approximation:saddle_peak, ...")
      ->allow_extra_args(false);
  command->add_option("--search", arguments->search,
                      "Options from a JSON file (io/schema/search.schema.json), weights and all");
  add_store_option(*command, arguments->store);
  command->add_flag("--no-evidence", arguments->no_evidence,
                    "Leave out errors of single sutures and further remodelling");
  command->add_flag("--json", arguments->json, "Print JSON");
  command->add_option("-o,--report", arguments->report, "Write a report with pictures (HTML)")
      ->check(CLI::Validator(refuse_standard_output, "FILE"));
  command->footer(
      "Closures in all: 1 of the valve as it is, at most --evaluations on searching, then for the\n"
      "ranking at most 65 for each of three times --plans finalists and the other nodes of the "
      "region\n"
      "(--region-points) for each of the best --plans; and 24 to 284 of evidence for each of "
      "those: one\n"
      "suture wrong alone, both independently, further remodelling. A report closes the valve and "
      "each\n"
      "ranked plan once more.\n\n"
      "A search killed at any time and run again with the same --store goes on where it was, to "
      "the\n"
      "same ranking.\n\n"
      "Ctrl-C stops the search and prints the best so far (exit code 130) when the closures in\n"
      "progress have ended. A second one ends coapt at once (130 in the shell): nothing is "
      "printed.\n\n"
      "Exit code 4 unless the best plan closes the valve robustly: all closures over its region\n"
      "converge without crossing, and mean + sd of the leak stay below 1 mm2. The ranking is then "
      "of the\n"
      "least bad.\n\n"
      "Examples:\n"
      "  coapt plan human-functional-mr --seed 1 -o report.html\n"
      "  coapt plan valve.json --fix ring30.json --forbid papillary_approximation:saddle_peak\n"
      "  coapt plan valve.json --plans 10 --store valve.sqlite --json > plans.json");
  command->callback([arguments, command, &status] { status = run(*command, *arguments); });
}

}  // namespace coapt
