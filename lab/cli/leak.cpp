#include <algorithm>
#include <filesystem>
#include <iostream>
#include <limits>
#include <memory>

#include "io/command_line/command_line.h"
#include "io/command_line/exit_code.h"
#include "io/command_line/files.h"
#include "lab/cli/chart_parts.h"
#include "lab/cli/commands.h"
#include "lab/leak/leak_tables.h"

namespace coapt {
namespace {

struct LeakArguments {
  LeakStudyOptions study;
  std::string directory = "leak";
  bool surfaces = false;
};

std::string path_in(const LeakArguments& arguments, const std::string& name) {
  return (std::filesystem::path(arguments.directory) / name).string();
}

int write(const LeakArguments& arguments, const std::vector<LeakCase>& cases) {
  if (const int error = write_output(path_in(arguments, "leaks.csv"), leaks_csv(cases)))
    return error;
  if (const int error = write_output(path_in(arguments, "openings.csv"), openings_csv(cases)))
    return error;
  for (const LeakCase& one : cases) {
    if (!arguments.surfaces || !one.is_trusted) continue;
    const std::string name = "surface-" + std::to_string(one.number) + ".json";
    if (const int error = write_output(path_in(arguments, name), surface_json(one))) return error;
  }
  return exit_code::kOk;
}

int run(const LeakArguments& arguments) {
  if (const Errors errors = make_directory(arguments.directory); !errors.empty()) {
    report_errors(arguments.directory, errors);
    return exit_code::kFailure;
  }
  if (const int error = check_output(path_in(arguments, "leaks.csv"))) return error;
  const std::vector<LeakCase> cases = study_leaks(arguments.study, [](int done, int planned) {
    std::cerr << done << " of " << planned << " valves\n";
  });
  if (const int error = write(arguments, cases)) return error;
  std::cout << agreements_table(leak_agreements(cases));
  const auto lost = std::count_if(cases.begin(), cases.end(),
                                  [](const LeakCase& one) { return !one.is_trusted; });
  if (lost > 0)
    std::cout << lost << " of " << cases.size() << " valves did not reach equilibrium\n";
  return exit_code::kOk;
}

}  // namespace

void add_leak(Command parent, int& status) {
  const auto arguments = std::make_shared<LeakArguments>();
  LeakStudyOptions& study = arguments->study;
  Command command = parent.add_command(
      "leak", "Compare every measure of the leak with the smallest surface on voxels");
  command.add_option("-o,--output", arguments->directory, "Directory for leaks.csv, openings.csv")
      .show_default();
  command.add_option("--count", study.count, "Presets, then drawn valves; odd ones are held out")
      .check(number_from(1, 100'000))
      .show_default();
  command.add_option("--seed", study.seed, "Random seed; the same seed gives the same valves")
      .check(number_from(std::uint64_t{0}, std::numeric_limits<std::uint64_t>::max()))
      .show_default();
  command.add_option("--finest", study.finest_mm, "The reference's smallest voxel, mm")
      .one_of(std::vector<double>{0.5, 0.25, 0.125});
  command.add_flag("--opened", study.opened, "Open the valves in diastole instead of closing them");
  command.add_flag("--surfaces", arguments->surfaces, "Write each valve's surface there, too");
  add_threads_option(command, study.threads, "areas");
  command.footer(
      "Of the drawn valves, one fifth each is unrepaired, has a ring, a clip, two neochordae, or a "
      "ring and\na clip. Takes seconds per valve, half a minute with --finest 0.125.\n\n"
      "Example:\n"
      "  coapt-lab leak --count 60 -o leak");
  command.on_run([arguments, &status] { status = run(*arguments); });
}

}  // namespace coapt
