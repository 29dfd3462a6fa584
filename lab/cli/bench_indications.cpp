#include <algorithm>
#include <iostream>
#include <memory>

#include "io/command_line/command_line.h"
#include "io/command_line/exit_code.h"
#include "io/command_line/files.h"
#include "io/command_line/interrupt.h"
#include "io/command_line/progress_bar.h"
#include "io/json/population_prior_json.h"
#include "lab/cli/bench_parts.h"
#include "lab/cli/commands.h"
#include "lab/indications/indications.h"

namespace coapt {
namespace {

struct BenchIndicationsArguments {
  std::string output = "indications.csv";
  std::vector<std::string> valves;
  int members = 18, challengers = -1;
  std::uint64_t population_seed = 11;
  IndicationOptions judged;
};

/// Presets and members, or those that are named.
Expected<std::vector<KnownDisease>> chosen_valves(const BenchIndicationsArguments& arguments) {
  Expected<std::vector<KnownDisease>> known = known_presets();
  if (!known) return known.errors();
  const Expected<std::vector<KnownDisease>> members = known_members(
      adult_prior(), arguments.population_seed, arguments.members, arguments.judged.search.threads);
  if (!members) return members.errors();
  known->insert(known->end(), members->begin(), members->end());
  for (const std::string& name : arguments.valves)
    if (std::none_of(known->begin(), known->end(),
                     [&](const KnownDisease& one) { return one.name == name; }))
      return Error{ErrorCode::BadReference, "--valve",
                   "is \"" + name +
                       "\", must be a valve of the table: atrial, ischaemic, dilated, "
                       "flail-dilated, one of the eight presets, or member-N with N below " +
                       std::to_string(arguments.members)};
  std::erase_if(*known,
                [&](const KnownDisease& one) { return !asked_for(arguments.valves, one.name); });
  return known;
}

int run(BenchIndicationsArguments arguments) {
  const std::atomic<bool>& interrupted = catch_interrupts();
  arguments.judged.challenge = arguments.challengers >= 0;
  arguments.judged.challengers = std::max(0, arguments.challengers);
  if (const int cannot = check_output(arguments.output)) return cannot;
  const Expected<std::vector<KnownDisease>> valves = chosen_valves(arguments);
  if (!valves) return report_errors("bench indications", valves.errors());
  std::vector<IndicationRow> rows;
  const ProgressBar bar;
  for (const KnownDisease& valve : *valves) {
    bar.show(std::ssize(rows), std::ssize(*valves), "valves: " + valve.name);
    const Expected<IndicationRow> row = judge_indication(valve, arguments.judged, interrupted);
    if (!row) return report_errors(valve.name, row.errors());
    if (interrupted) return exit_code::kInterrupted;
    rows.push_back(*row);
    // One that is cut leaves what it has.
    if (const int cannot = write_output(arguments.output, indications_csv(rows))) return cannot;
  }
  const auto indicated = std::count_if(rows.begin(), rows.end(),
                                       [](const IndicationRow& row) { return row.indicated; });
  std::cout << "The first plan is indicated on " << indicated << " of " << rows.size()
            << " valves.\n";
  return exit_code::kOk;
}

}  // namespace

void add_bench_indications(Command parent, int& status) {
  const auto arguments = std::make_shared<BenchIndicationsArguments>();
  SearchOptions& search = arguments->judged.search;
  search.evaluations = 300;
  search.plans = 3;
  search.region_points = 17;
  Command command = parent.add_command(
      "indications", "Tabulate whether first plans are indicated by the disease of the valve");
  command.add_option("-o,--output", arguments->output, "File for the table (CSV)").show_default();
  command.add_option("--valve", arguments->valves,
                     "Some of the table's valves (default: eight presets, four remodelled ones and "
                     "the members)");
  command.add_option("--members", arguments->members, "Number of members of a population of adults")
      .check(number_from(0, 1000))
      .show_default();
  command.add_option("--population-seed", arguments->population_seed, "Other members")
      .check(number_from(std::uint64_t{0}, std::numeric_limits<std::uint64_t>::max()))
      .show_default();
  command.add_option("--evaluations", search.evaluations, "Number of closures of a search")
      .check(number_from(1, 100000))
      .show_default();
  command.add_option("--seed", search.seed, "Random seed of the first search of a valve")
      .check(number_from(std::uint64_t{0}, std::uint64_t{1} << 53))
      .show_default();
  command
      .add_option("--seeds", arguments->judged.seeds,
                  "Number of searches per valve, whose first plans are ranked together")
      .check(number_from(1, 100))
      .show_default();
  command
      .add_option("--challenge", arguments->challengers,
                  "Score every ring alone and N plans at random, all with fewer steps than the "
                  "first plan")
      .check(number_from(0, 100000))
      .show_argument("N");
  command
      .add_option("--threads", search.threads,
                  "Number of threads (0: all cores); does not change the table")
      .check(number_from(0, 1024))
      .show_default();
  command.footer(
      "A search of 300 closures takes about 50 s of a core, a challenger half a second. The table "
      "is\nwritten after each valve.\n\n"
      "Examples:\n"
      "  coapt-lab bench indications -o indications.csv\n"
      "  coapt-lab bench indications --valve ischaemic --seeds 3 --challenge 100");
  command.on_run([arguments, &status] { status = run(*arguments); });
}

}  // namespace coapt
