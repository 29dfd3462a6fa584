#include "lab/lattices/rival_runs.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <sstream>

#include "io/json/plan_json.h"
#include "lab/lattices/program_lines.h"
#include "lab/rivals/rivals.h"
#include "search/plans/exploration.h"

namespace coapt {
namespace {

namespace fs = std::filesystem;

}  // namespace

rivals::LatticeTable table_of(const SolvedLattice& lattice) {
  rivals::LatticeTable table{lattice.of.name, {}, lattice.costs, lattice.plans};
  for (const FlatVariable& variable : lattice.flat->variables())
    table.variables.push_back({variable.name, variable.ordered, variable.count});
  return table;
}

std::string outside_program(const std::string& given) {
  if (!given.empty()) return given;
  std::error_code failed;
  const fs::path here = fs::read_symlink("/proc/self/exe", failed).parent_path();
  for (const fs::path& place : {here, here / "../../rivals/bin"})
    if (fs::exists(place / "coapt-rivals", failed)) return (place / "coapt-rivals").string();
  return "";
}

rivals::MeasuredRun measured_run(const RivalTask& task, int budget, const std::string& outside) {
  const std::vector<std::string> here = rivals::rival_names();
  const double best = task.lattice->sorted_costs.front();
  const auto paid = [&](int plans) {
    return static_cast<int>(std::lround(task.lattice->closures_a_plan * plans));
  };
  rivals::MeasuredRun run{task.method, task.lattice->of.name, task.seed, {}, 0};
  if (task.method == "coapt") {
    SearchOptions options;
    options.seed = task.seed;
    options.plans = 1;
    options.evaluations = paid(budget);
    const LatticeRun ours = search_lattice(*task.lattice, options);
    for (const Progress& step : ours.improvements)
      run.improvements.emplace_back(step.closures - 1, step.cost - best);
    run.spent = ours.closures;
  } else if (std::find(here.begin(), here.end(), task.method) != here.end()) {
    const rivals::RivalRun theirs =
        rivals::run_rival(table_of(*task.lattice), {task.method, task.seed, budget, {}});
    for (const rivals::Improvement& step : theirs.improvements)
      run.improvements.emplace_back(paid(step.evaluations), step.cost - best);
    run.spent = paid(theirs.evaluations);
  } else {
    std::ostringstream command;
    command << '\'' << outside << "' '" << task.file << "' " << task.method << ' ' << task.seed
            << ' ' << budget;
    run.spent = paid(budget);  // if it was killed
    for (const std::string& line : lines_of(command.str())) {
      const std::size_t second = line.find(',', line.find(',') + 1);
      int evaluations = 0;
      double cost = 0.0;
      if (second == std::string::npos) continue;
      const int read = std::sscanf(line.c_str() + second, ",%d,%lf", &evaluations, &cost);
      if (read == 2) run.improvements.emplace_back(paid(evaluations), cost - best);
      if (read == 1 && line.ends_with(",end")) run.spent = paid(evaluations);
    }
  }
  return run;
}

std::vector<std::string> compared_methods(const std::string& outside) {
  std::vector<std::string> methods = {"coapt"};
  for (const std::string& name : rivals::rival_names()) methods.push_back(name);
  if (!outside.empty())
    for (const std::string& name : lines_of('\'' + outside + "' --list")) methods.push_back(name);
  return methods;
}

}  // namespace coapt
