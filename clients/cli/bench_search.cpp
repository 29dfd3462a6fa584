#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>
#include <mutex>

#include "bench/rivals/ert.h"
#include "clients/cli/commands.h"
#include "clients/cli/exit_code.h"
#include "clients/cli/files.h"
#include "clients/cli/interrupt.h"
#include "clients/cli/number_option.h"
#include "clients/cli/plan_store_option.h"
#include "clients/cli/progress_bar.h"
#include "clients/cli/rival_report.h"
#include "clients/cli/rival_runs.h"
#include "io/json/plan_json.h"
#include "io/json/result_json.h"
#include "search/parallel.h"
#include "search/plans/exploration.h"
#include "search/plans/lattice_findings.h"

namespace coapt {
namespace {

namespace fs = std::filesystem;

struct BenchSearchArguments {
  std::string directory = "bench-search", rivals;
  std::string real = "examples/valves/bodyparts3d-leaking.json";
  std::vector<std::string> lattices, methods;
  int seeds = 15, budget = 500, threads = 0;
  bool json = false;
};

Hits hits_of(const SolvedLattice& lattice, int seeds, int threads) {
  Hits hits{lattice.of.name, lattice.sorted_costs.size(), seeds};
  std::vector<double> winners(static_cast<std::size_t>(seeds));
  for_each_index(seeds, threads, [&](int i) {
    SearchOptions options;
    options.seed = static_cast<std::uint64_t>(i) + 1;
    winners[static_cast<std::size_t>(i)] =
        search_lattice(lattice, options, ring_catalogue()).winner;
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

int run(const BenchSearchArguments& arguments) {
  const std::atomic<bool>& interrupted = catch_interrupts();
  const Expected<Valve> real = read_valve_argument(arguments.real);
  if (!real) return report_errors(arguments.real, real.errors());
  std::error_code failed;
  fs::create_directories(arguments.directory, failed);
  const auto path = [&](const std::string& name) {
    return (fs::path(arguments.directory) / name).string();
  };
  if (const int cannot = check_output(path("ert.csv"))) return cannot;
  std::vector<LatticeCase> cases = lattice_cases(*real);
  for (const std::string& name : arguments.lattices)
    if (std::none_of(cases.begin(), cases.end(), [&](const auto& c) { return c.name == name; }))
      return report_errors("bench search",
                           {{ErrorCode::BadReference, "--lattice",
                             "is \"" + name +
                                 "\", must be functional, porcine-both, human-pm, real, ischaemic "
                                 "or flail-p2"}});
  std::vector<SolvedLattice> solved;
  for (const LatticeCase& one : cases) {
    const auto& wanted = arguments.lattices;
    if (!wanted.empty() && std::find(wanted.begin(), wanted.end(), one.name) == wanted.end())
      continue;
    SearchContext context{.catalogue = ring_catalogue(), .cancelled = &interrupted};
    const auto store = use_store(path("lattices.sqlite"), one.valve, {}, context);
    if (!store) return report_store_errors("bench search", store.errors());
    const ProgressBar bar;
    context.progress = [&](const SearchProgress& progress) {
      if (progress.closures % 64 == 0) bar.show(progress);
    };
    std::optional<SolvedLattice> lattice = solve_lattice(one, arguments.threads, context);
    if (!lattice) return exit_code::kInterrupted;
    solved.push_back(std::move(*lattice));
    if (const int cannot = write_output(path("lattice-" + one.name + ".txt"),
                                        rivals::write_lattice(table_of(solved.back()))))
      return cannot;
  }

  std::vector<Hits> hits;
  for (const SolvedLattice& lattice : solved)
    hits.push_back(hits_of(lattice, arguments.seeds, arguments.threads));

  const std::string outside = outside_program(arguments.rivals);
  if (outside.empty())
    std::cerr << "coapt: bench search: without pagmo, dlib and COBYLA (make rivals builds them)\n";
  std::vector<RivalTask> tasks;
  for (const std::string& method : compared_methods(outside)) {
    const auto& only = arguments.methods;
    if (!only.empty() && std::find(only.begin(), only.end(), method) == only.end()) continue;
    for (const SolvedLattice& lattice : solved)
      for (int seed = 1; seed <= arguments.seeds; ++seed)
        tasks.push_back({&lattice, method, path("lattice-" + lattice.of.name + ".txt"),
                         static_cast<std::uint64_t>(seed)});
  }
  std::vector<rivals::MeasuredRun> runs(tasks.size());
  {
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
  }
  if (interrupted) return exit_code::kInterrupted;

  const std::vector<rivals::Ert> rows = rivals::expected_running_times(runs);
  auto by_lattice = nlohmann::ordered_json::object();
  for (const SolvedLattice& lattice : solved)
    by_lattice[lattice.of.name] = to_json(rivals::expected_running_times(runs, lattice.of.name));
  auto all_hits = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < hits.size(); ++i) {
    all_hits.push_back(to_json(hits[i]));
    all_hits.back().update(to_json(findings_of(solved[i], ring_catalogue())));
  }
  const nlohmann::ordered_json json = {{"schema", "coapt.bench-search/1"},
                                       {"version", version()},
                                       {"seeds", arguments.seeds},
                                       {"budget_plans", arguments.budget},
                                       {"closures_a_plan", kChosenBy},
                                       {"lattices", all_hits},
                                       {"ert", to_json(rows)},
                                       {"ert_by_lattice", by_lattice}};
  for (const auto& [name, content] :
       {std::pair<std::string, std::string>{"ert.csv", rivals::ert_csv(rows)},
        {"ecdf.svg", reached_chart(runs, rows)},
        {"bench.json", json.dump(2)}})
    if (const int cannot = write_output(path(name), content)) return cannot;
  if (arguments.json) {
    std::cout << json.dump(2) << '\n';
  } else {
    print_hits(std::cout, hits);
    print_times(std::cout, rows);
  }
  return exit_code::kOk;
}

}  // namespace

void add_bench_search(CLI::App& bench, int& status) {
  const auto arguments = std::make_shared<BenchSearchArguments>();
  CLI::App* command = bench.add_subcommand(
      "search", "The search against its rivals on exhaustively solved lattices");
  command->add_option("-o,--output", arguments->directory, "Directory for ert.csv, ecdf.svg, ...")
      ->capture_default_str();
  command->add_option("--lattice", arguments->lattices,
                      "Some of functional, porcine-both, human-pm, real, ischaemic, flail-p2");
  command->add_option("--method", arguments->methods, "Some of coapt, random, sobol, bobyqa, ...");
  command->add_option("--seeds", arguments->seeds, "Runs of each method on each lattice")
      ->check(number_from(1, 1000))
      ->capture_default_str();
  command->add_option("--budget", arguments->budget, "Plans that a rival may close, 17 times each")
      ->check(number_from(1, 100000))
      ->capture_default_str();
  command->add_option("--threads", arguments->threads, "0: all cores")
      ->check(number_from(0, 1024))
      ->capture_default_str();
  command->add_option("--real", arguments->real, "The measured valve of lattice real")
      ->capture_default_str();
  command->add_option("--rivals", arguments->rivals,
                      "The program with pagmo and dlib; by default coapt-rivals of make rivals");
  command->add_flag("--json", arguments->json, "Print JSON");
  command->footer(
      "Solving the six lattices takes 400,000 closures (half an hour on two cores); they are kept "
      "in\n"
      "lattices.sqlite in the directory, so that a second run takes minutes.\n\n"
      "Examples:\n"
      "  coapt bench search -o bench-search --json\n"
      "  coapt bench search --lattice functional --seeds 5 --method coapt random bobyqa");
  command->callback([arguments, &status] { status = run(*arguments); });
}

}  // namespace coapt
