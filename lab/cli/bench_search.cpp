#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>
#include <mutex>

#include "clients/cli/plan_store_option.h"
#include "clients/cli/read_argument.h"
#include "clients/cli/search_progress.h"
#include "io/command_line/command_line.h"
#include "io/command_line/exit_code.h"
#include "io/command_line/files.h"
#include "io/command_line/interrupt.h"
#include "io/json/plan_json.h"
#include "io/json/result_json.h"
#include "io/json/version.h"
#include "lab/cli/bench_parts.h"
#include "lab/cli/commands.h"
#include "lab/cli/draw.h"
#include "lab/lattices/lattice_findings.h"
#include "lab/lattices/rival_report.h"
#include "lab/lattices/rival_runs.h"
#include "lab/rivals/ert.h"
#include "search/parallel.h"
#include "search/plans/exploration.h"

namespace coapt {
namespace {

namespace fs = std::filesystem;

struct BenchSearchArguments {
  std::string directory = "bench-search", rivals;
  std::string real = "examples/valves/bodyparts3d-leaking.json";
  std::vector<std::string> lattices, methods;
  int seeds = 15, budget = 500, threads = 0;
  bool by_rule = false, json = false;
};

Hits hits_of(const SolvedLattice& lattice, int seeds, int threads) {
  Hits hits{lattice.of.name, lattice.sorted_costs.size(), seeds};
  std::vector<double> winners(static_cast<std::size_t>(seeds));
  for_each_index(seeds, threads, [&](int i) {
    SearchOptions options;
    options.seed = static_cast<std::uint64_t>(i) + 1;
    winners[static_cast<std::size_t>(i)] = search_lattice(lattice, options).winner;
  });
  const double best = lattice.sorted_costs.front();
  const double percent =
      lattice.sorted_costs[std::max<std::size_t>(1, lattice.sorted_costs.size() / 100) - 1];
  for (const double winner : winners) {
    hits.optimum += winner <= best;
    hits.top_percent += winner <= percent;
    hits.regret_mean += (winner - best) / seeds;
    hits.regret_worst = std::max(hits.regret_worst, winner - best);
  }
  return hits;
}

std::string path_in(const BenchSearchArguments& arguments, const std::string& name) {
  return (fs::path(arguments.directory) / name).string();
}

/// Adds the solved lattice to `solved` and writes its table for the program outside; returns an exit code.
int solve(const BenchSearchArguments& arguments, const LatticeCase& one,
          const std::atomic<bool>& interrupted, std::vector<SolvedLattice>& solved) {
  SearchContext context{.cancelled = &interrupted};
  const auto store = use_store(path_in(arguments, "lattices.sqlite"), one.valve, {}, context);
  if (!store) return report_store_errors("bench search", store.errors());
  const ProgressBar bar;
  context.progress = [&](const SearchProgress& progress) {
    if (progress.closures % 64 == 0) show(bar, progress);
  };
  std::optional<SolvedLattice> lattice = solve_lattice(one, arguments.threads, context);
  if (!lattice) return exit_code::kInterrupted;
  solved.push_back(std::move(*lattice));
  return write_output(path_in(arguments, "lattice-" + one.name + ".txt"),
                      rivals::write_lattice(table_of(solved.back())));
}

std::vector<RivalTask> tasks_of(const BenchSearchArguments& arguments,
                                const std::vector<SolvedLattice>& solved,
                                const std::string& outside) {
  std::vector<RivalTask> tasks;
  for (const std::string& method : compared_methods(outside)) {
    if (!asked_for(arguments.methods, method)) continue;
    for (const SolvedLattice& lattice : solved)
      for (int seed = 1; seed <= arguments.seeds; ++seed)
        tasks.push_back({&lattice, method,
                         path_in(arguments, "lattice-" + lattice.of.name + ".txt"),
                         static_cast<std::uint64_t>(seed)});
  }
  return tasks;
}

std::vector<rivals::MeasuredRun> measure(const BenchSearchArguments& arguments,
                                         const std::vector<RivalTask>& tasks,
                                         const std::string& outside,
                                         const std::atomic<bool>& interrupted) {
  std::vector<rivals::MeasuredRun> runs(tasks.size());
  const ProgressBar bar;
  std::mutex mutex;
  int done = 0;
  for_each_index(static_cast<int>(tasks.size()), arguments.threads, [&](int i) {
    if (interrupted) return;
    const RivalTask& task = tasks[static_cast<std::size_t>(i)];
    runs[static_cast<std::size_t>(i)] = measured_run(task, arguments.budget, outside);
    const std::lock_guard<std::mutex> lock(mutex);
    bar.show(++done, static_cast<int>(tasks.size()), "runs: " + task.method);
  });
  return runs;
}

Json json_of(const BenchSearchArguments& arguments, const std::vector<SolvedLattice>& solved,
             const std::vector<Hits>& hits, const std::vector<rivals::MeasuredRun>& runs) {
  auto by_lattice = Json::object();
  auto lattices = Json::array();
  for (std::size_t i = 0; i < hits.size(); ++i) {
    lattices.push_back(to_json(hits[i]));
    lattices.back().update(to_json(findings_of(solved[i])));
    lattices.back()["closures_a_plan"] = solved[i].closures_a_plan;
    const std::string& name = solved[i].of.name;
    by_lattice[name] = to_json(rivals::expected_running_times(runs, name));
  }
  return {{"schema", "coapt.bench-search/1"},
          {"version", version()},
          {"revision", revision_json()},
          {"seeds", arguments.seeds},
          {"budget_plans", arguments.budget},
          {"lattices", lattices},
          {"ert", to_json(rivals::expected_running_times(runs))},
          {"ert_by_lattice", by_lattice}};
}

/// Lets the search and its rivals run on solved lattices, and writes what came of it.
int compare(const BenchSearchArguments& arguments, const std::vector<SolvedLattice>& solved,
            const std::atomic<bool>& interrupted) {
  std::vector<Hits> hits;
  for (const SolvedLattice& lattice : solved)
    hits.push_back(hits_of(lattice, arguments.seeds, arguments.threads));
  const std::string outside = outside_program(arguments.rivals);
  if (outside.empty())
    std::cerr << "coapt-lab: bench search: without pagmo, dlib and COBYLA (make rivals builds "
                 "them)\n";
  const std::vector<rivals::MeasuredRun> runs =
      measure(arguments, tasks_of(arguments, solved, outside), outside, interrupted);
  if (interrupted) return exit_code::kInterrupted;

  const std::vector<rivals::Ert> rows = rivals::expected_running_times(runs);
  const Json json = json_of(arguments, solved, hits, runs);
  for (const auto& [name, content] :
       {std::pair<std::string, std::string>{"ert.csv", rivals::ert_csv(rows)},
        {"ecdf.csv", ecdf_csv(runs, rows)},
        {"bench.json", json.dump(2)}})
    if (const int cannot = write_output(path_in(arguments, name), content)) return cannot;
  draw(path_in(arguments, "ecdf.csv"));
  if (arguments.json) {
    std::cout << json.dump(2) << '\n';
  } else {
    print_hits(std::cout, hits);
    print_times(std::cout, rows);
  }
  return exit_code::kOk;
}

int run(const BenchSearchArguments& arguments) {
  const std::atomic<bool>& interrupted = catch_interrupts();
  const Expected<Valve> real = read_valve_argument(arguments.real);
  if (!real) return report_errors(arguments.real, real.errors());
  std::error_code failed;
  fs::create_directories(arguments.directory, failed);
  if (const int cannot = check_output(path_in(arguments, "ert.csv"))) return cannot;
  const Expected<std::vector<LatticeCase>> cases = chosen_cases(arguments.lattices, *real);
  if (!cases) return report_errors("bench search", cases.errors());
  std::vector<SolvedLattice> solved;
  for (const LatticeCase& one : *cases)
    if (const int status =
            solve(arguments, arguments.by_rule ? by_rule(one) : one, interrupted, solved))
      return status;
  return compare(arguments, solved, interrupted);
}

}  // namespace

void add_bench_search(Command parent, int& status) {
  const auto arguments = std::make_shared<BenchSearchArguments>();
  Command command = parent.add_command(
      "search", "Compare the search with its rivals on exhaustively solved lattices");
  command
      .add_option("-o,--output", arguments->directory,
                  "Directory for ert.csv, ecdf.csv, ecdf.png, bench.json")
      .show_default();
  command.add_option("--lattice", arguments->lattices,
                     "Some of functional, porcine-both, human-pm, real, ischaemic, flail-p2");
  command.add_option("--method", arguments->methods, "Some of coapt, random, sobol, bobyqa, ...");
  command.add_option("--seeds", arguments->seeds, "Number of runs of each method on each lattice")
      .check(number_from(1, 1000))
      .show_default();
  command
      .add_option("--budget", arguments->budget,
                  "Maximum number of plans for a rival, at 17 closures each")
      .check(number_from(1, 100000))
      .show_default();
  command.add_option("--threads", arguments->threads, "Number of threads (0: all cores)")
      .check(number_from(0, 1024))
      .show_default();
  command.add_option("--real", arguments->real, "The measured valve of the lattice named real")
      .show_default();
  command.add_option("--rivals", arguments->rivals,
                     "The program with the optimisers of pagmo and dlib (default: coapt-rivals "
                     "beside this one, if make rivals built it)");
  command.add_flag("--rule", arguments->by_rule,
                   "Score plans by the rule that ranks, each opened and closed under further "
                   "disease, on coarser lattices, instead of by price");
  command.add_flag("--json", arguments->json, "Print JSON");
  command.footer(
      "Solving the six lattices takes 400,000 closures (half an hour on two cores). They are "
      "stored in\nlattices.sqlite in the output directory, so an interrupted run resumes, and a "
      "second one "
      "takes\n"
      "minutes.\n\n"
      "Examples:\n"
      "  coapt-lab bench search -o bench-search --json\n"
      "  coapt-lab bench search --lattice functional --seeds 5 --method coapt random bobyqa");
  command.on_run([arguments, &status] { status = run(*arguments); });
}

}  // namespace coapt
