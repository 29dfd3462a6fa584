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
#include "io/json/subject.h"
#include "lab/cli/bench_parts.h"
#include "lab/cli/commands.h"
#include "lab/cli/draw.h"
#include "lab/lattices/front_runs.h"
#include "lab/lattices/opening_file.h"
#include "lab/lattices/rival_runs.h"
#include "search/parallel.h"

namespace coapt {
namespace {

namespace fs = std::filesystem;

struct BenchFrontArguments {
  std::string directory = "bench-front", rivals;
  std::string real = "examples/valves/bodyparts3d-leaking.json";
  std::vector<std::string> lattices, methods;
  int seeds = 9, budget = 1000, threads = 0;
};

std::string path_in(const BenchFrontArguments& arguments, const std::string& name) {
  return (fs::path(arguments.directory) / name).string();
}

/// Adds the solved lattice to `solved`; returns an exit code.
int solve(const BenchFrontArguments& arguments, const LatticeCase& one,
          const std::atomic<bool>& interrupted, std::vector<SolvedFront>& solved) {
  SearchContext context{.cancelled = &interrupted};
  const auto store = use_store(path_in(arguments, "fronts.sqlite"), one.valve, {}, context);
  if (!store) return report_store_errors("bench front", store.errors());
  const std::string file = path_in(arguments, "openings-" + one.name + ".json");
  KnownOpenings openings;
  const std::string subject = plan_subject_of(one.valve, {});
  if (const auto text = read_input(file)) openings = read_openings(subject, *text);
  const ProgressBar bar;
  context.progress = [&](const SearchProgress& progress) {
    if (progress.closures % 64 == 0) show(bar, progress);
  };
  std::optional<SolvedFront> front = solve_front(
      one, arguments.threads, context, std::move(openings),
      [&](const KnownOpenings& made) { write_output(file, write_openings(subject, made)); });
  if (!front) return exit_code::kInterrupted;
  solved.push_back(std::move(*front));
  return exit_code::kOk;
}

std::vector<FrontRun> measure(const BenchFrontArguments& arguments,
                              const std::vector<SolvedFront>& solved,
                              const std::vector<std::vector<std::string>>& files,
                              const std::string& outside, const std::atomic<bool>& interrupted) {
  if (outside.empty())
    std::cerr << "coapt-lab: bench front: without NSGA-II and MOEA/D (make rivals builds them)\n";
  std::vector<FrontTask> tasks;
  for (const std::string& method : front_methods(outside)) {
    if (!asked_for(arguments.methods, method)) continue;
    for (std::size_t i = 0; i < solved.size(); ++i)
      for (int seed = 1; seed <= arguments.seeds; ++seed)
        tasks.push_back({&solved[i], method, static_cast<std::uint64_t>(seed), files[i]});
  }
  std::vector<FrontRun> runs(tasks.size());
  const ProgressBar bar;
  std::mutex mutex;
  int done = 0;
  for_each_index(static_cast<int>(tasks.size()), arguments.threads, [&](int i) {
    if (interrupted) return;
    const FrontTask& task = tasks[static_cast<std::size_t>(i)];
    runs[static_cast<std::size_t>(i)] = front_run(task, arguments.budget, outside);
    const std::lock_guard<std::mutex> lock(mutex);
    bar.show(++done, static_cast<int>(tasks.size()), "runs: " + task.method);
  });
  return runs;
}

int run(const BenchFrontArguments& arguments) {
  const std::atomic<bool>& interrupted = catch_interrupts();
  const Expected<Valve> real = read_valve_argument(arguments.real);
  if (!real) return report_errors(arguments.real, real.errors());
  std::error_code failed;
  fs::create_directories(arguments.directory, failed);
  if (const int cannot = check_output(path_in(arguments, "front.csv"))) return cannot;
  const Expected<std::vector<LatticeCase>> cases = chosen_cases(arguments.lattices, *real);
  if (!cases) return report_errors("bench front", cases.errors());
  const std::string outside = outside_program(arguments.rivals);
  const std::vector<std::string> methods = front_methods(outside);
  for (const std::string& method : arguments.methods)
    if (std::find(methods.begin(), methods.end(), method) == methods.end())
      return report_errors("bench front",
                           {Error{ErrorCode::BadReference, "--method", "there is no " + method}});
  std::vector<SolvedFront> solved;
  std::vector<std::vector<std::string>> files;
  for (const LatticeCase& one : *cases) {
    if (const int status = solve(arguments, one, interrupted, solved)) return status;
    files.emplace_back();
    for (const rivals::LatticeTable& table : objective_tables(solved.back())) {
      files.back().push_back(path_in(
          arguments, "objective-" + std::to_string(files.back().size()) + '-' + one.name + ".txt"));
      if (const int cannot = write_output(files.back().back(), rivals::write_lattice(table)))
        return cannot;
    }
  }
  const std::vector<FrontRun> runs = measure(arguments, solved, files, outside, interrupted);
  if (interrupted) return exit_code::kInterrupted;
  const std::string csv = front_csv(solved, runs);
  for (const auto& [name, content] : {std::pair<std::string, std::string>{"front.csv", csv},
                                      {"front-rise.csv", front_rise_csv(runs)}})
    if (const int cannot = write_output(path_in(arguments, name), content)) return cannot;
  draw(path_in(arguments, "front-rise.csv"));
  std::cout << csv;
  return exit_code::kOk;
}

}  // namespace

void add_bench_front(Command parent, int& status) {
  const auto arguments = std::make_shared<BenchFrontArguments>();
  Command command = parent.add_command(
      "front", "Compare how fast the search and its rivals find the Pareto front");
  command
      .add_option("-o,--output", arguments->directory,
                  "Directory for front.csv, front-rise.csv, front-rise.png")
      .show_default();
  command.add_option("--lattice", arguments->lattices,
                     "Some of functional, porcine-both, human-pm, real, ischaemic, flail-p2");
  command.add_option("--method", arguments->methods,
                     "Some of coapt, random, pagmo_nsga2, pagmo_moead");
  command.add_option("--seeds", arguments->seeds, "Number of runs of each method on each lattice")
      .check(number_from(1, 1000))
      .show_default();
  command.add_option("--threads", arguments->threads, "Number of threads (0: all cores)")
      .check(number_from(0, 1024))
      .show_default();
  command
      .add_option("--budget", arguments->budget,
                  "Maximum number of plans for a rival; coapt stops by itself, after at most 3,000 "
                  "closures")
      .check(number_from(1, 100000))
      .show_default();
  command.add_option("--real", arguments->real, "The measured valve of the lattice named real")
      .show_default();
  command.add_option("--rivals", arguments->rivals,
                     "The program with the optimisers of pagmo (default: coapt-rivals beside this "
                     "one, if make rivals built it)");
  command.footer(
      "Closures and openings are stored in the output directory, so an interrupted run resumes.\n\n"
      "Examples:\n"
      "  coapt-lab bench front -o bench-front\n"
      "  coapt-lab bench front --lattice functional --seeds 3");
  command.on_run([arguments, &status] { status = run(*arguments); });
}

}  // namespace coapt
