#include <algorithm>
#include <iostream>
#include <memory>
#include <string>

#include "clients/cli/commands.h"
#include "clients/cli/farm_option.h"
#include "clients/cli/read_argument.h"
#include "clients/cli/run_options.h"
#include "clients/cli/study_directory.h"
#include "core/presets/presets.h"
#include "io/command_line/command_line.h"
#include "io/command_line/exit_code.h"
#include "io/command_line/files.h"
#include "io/picture/study_csv.h"
#include "io/picture/study_page.h"
#include "io/picture/text.h"
#include "search/studies/generality.h"

namespace coapt {
namespace {

struct StudyGeneralityArguments {
  std::vector<std::string> valves;
  std::string directory = "study-generality", farm;
  int anatomies = 50, threads = 0;
  std::uint64_t seed = 1;
};

/// Quicker than the thesis's: displacements by 2 mm, approximations by 6 mm.
ThesisStudyOptions quick_studies() {
  ThesisStudyOptions options;
  options.papillary_nodes = 4;
  options.protocols = {Protocol::LookupClamped, Protocol::Closed};
  options.approximation = {6.0, 17, 5.0};
  options.scan_sites = 0;
  return options;
}

std::string kind_of(const std::string& preset) {
  if (preset == "human-functional-mr" || preset == "human-p2-prolapse") return "leaking presets";
  if (preset.starts_with("porcine-thesis")) return "calibrated";
  if (preset.starts_with("porcine")) return "porcine presets";
  return preset.starts_with("human") ? "human presets" : "disease presets";
}

/// Presets, the files given, random anatomies.
Expected<std::vector<StudiedValve>> gather(const StudyGeneralityArguments& arguments, int& drawn) {
  std::vector<StudiedValve> valves;
  for (const std::string& name : preset_names()) {
    const Expected<Valve> valve = make_preset(name);
    if (!valve) return valve.errors();
    valves.push_back({kind_of(name), *valve});
  }
  for (const std::string& file : arguments.valves) {
    const Expected<Valve> valve = read_valve_argument(file);
    if (!valve) {
      Errors errors = valve.errors();
      for (Error& error : errors) error.message = file + ": " + error.message;
      return errors;
    }
    valves.push_back({"given", *valve});
  }
  const RandomAnatomies random =
      random_anatomies(arguments.anatomies, arguments.seed, arguments.threads);
  drawn = random.drawn;
  for (const Valve& valve : random.valves) valves.push_back({"random anatomies", valve});
  return valves;
}

std::vector<std::vector<std::string>> shares_table(const std::vector<FindingShare>& shares) {
  std::vector<std::string> kinds = {""};
  for (const FindingShare& share : shares)
    if (std::find(kinds.begin(), kinds.end(), share.kind) == kinds.end())
      kinds.push_back(share.kind);
  std::vector<std::vector<std::string>> rows = {{"finding"}};
  for (const std::string& kind : kinds) rows[0].push_back(kind.empty() ? "all" : kind);
  for (const FindingShare& share : shares) {
    if (!share.kind.empty()) continue;
    rows.push_back({share.finding});
    for (const std::string& kind : kinds) {
      const auto at = std::find_if(shares.begin(), shares.end(), [&](const FindingShare& s) {
        return s.finding == share.finding && s.kind == kind;
      });
      rows.back().push_back(at == shares.end()
                                ? ""
                                : std::to_string(at->agree) + " of " + std::to_string(at->valves));
    }
  }
  return rows;
}

int run(const StudyGeneralityArguments& arguments) {
  int drawn = 0;
  const Expected<std::vector<StudiedValve>> valves = gather(arguments, drawn);
  if (!valves) return report_errors("study generality", valves.errors());
  const Expected<std::unique_ptr<StudyDirectory>> opened = StudyDirectory::open(
      arguments.directory, {arguments.threads, arguments.farm, "coapt study generality"});
  if (!opened) {
    report_errors("study generality", opened.errors());
    return exit_code::kFailure;
  }
  StudyDirectory& directory = **opened;
  const auto name_of = [&](int index) {
    const std::string of = " of " + std::to_string(valves->size());
    directory.begin("valve " + std::to_string(index + 1) + of);
  };
  name_of(0);
  const std::vector<ValveFindings> studied = study_generality(
      *valves, [&](const Valve& valve) { return directory.table(valve, ClosureOptions{}); },
      {quick_studies(), directory.valves_at_once(), [&](int done, int) { name_of(done); }});
  const std::vector<FindingShare> shares = finding_shares(studied);
  int configurations = 0, closures = 0, untrusted = 0;
  for (const ValveFindings& valve : studied) {
    configurations += valve.configurations;
    closures += valve.closures;
    untrusted += valve.untrusted;
  }
  const std::string lead =
      std::to_string(studied.size()) +
      " valves; displacements in steps of 2 mm, approximations of those of 6 mm, 17 nodes of each "
      "region. The presets are mirror-symmetric except for the calibrated ones; random asymmetry "
      "is of either sign. The random anatomies are the competent ones of " +
      std::to_string(drawn) + " drawn. " + std::to_string(configurations) +
      " configurations closed, " + std::to_string(untrusted) + " not trusted.";
  const std::string page =
      study_page("Generality of the findings of the thesis", lead,
                 {{"Number of valves on which each finding holds", "", "", shares_table(shares)}});
  for (const auto& [name, content] :
       {std::pair<std::string, std::string>{"findings.csv", generality_csv(studied)},
        {"shares.csv", finding_shares_csv(shares)},
        {"index.html", page}})
    if (const int error = directory.write(name, content)) return error;
  for (const FindingShare& share : shares)
    if (share.kind.empty())
      std::cout << share.agree << " of " << share.valves << "  " << share.finding << '\n';
  std::cout << lead << ' ' << closures << " new closures in " << fixed(directory.seconds(), 0)
            << " s.\nWritten to " << printable(arguments.directory) << "/index.html\n";
  return exit_code::kOk;
}

}  // namespace

void add_generality(Command parent, int& status) {
  const auto arguments = std::make_shared<StudyGeneralityArguments>();
  Command command = parent.add_command(
      "generality", "Measure on what fraction of many valves each finding of the thesis holds");
  command.add_option("valves", arguments->valves, "Valve files, in addition to the presets");
  command.add_option("-o,--output", arguments->directory, "Directory for CSV and index.html")
      .show_default();
  command.add_option("--anatomies", arguments->anatomies, "Number of random anatomies")
      .check(number_from(0, 10000))
      .show_default();
  add_seed_option(command, arguments->seed, "Seed of the random anatomies");
  add_threads_option(command, arguments->threads);
  add_farm_option(command, arguments->farm, "Compute the closures");
  command.footer(
      "Each valve takes about 2,000 closures: displacements in steps of 2 mm, approximations of "
      "those of\n6 mm, 17 points of each region. With --farm, sixteen valves are processed at a "
      "time; random\nanatomies are drawn on this machine.\n\n"
      "Examples:\n"
      "  coapt study generality examples/valves/bodyparts3d.json -o generality\n"
      "  coapt study generality --anatomies 1000 --farm postgresql://farm.example/coapt -o "
      "general");
  command.on_run([arguments, &status] { status = run(*arguments); });
}

}  // namespace coapt
