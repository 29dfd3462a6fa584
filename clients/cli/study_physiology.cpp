#include <cmath>
#include <iostream>
#include <memory>
#include <string>

#include "clients/cli/commands.h"
#include "clients/cli/plan_option.h"
#include "clients/cli/print_table.h"
#include "clients/cli/read_argument.h"
#include "core/valve/number_text.h"
#include "io/command_line/exit_code.h"
#include "io/command_line/progress_bar.h"
#include "io/json/physiology_json.h"

namespace coapt {
namespace {

struct StudyPhysiologyArguments {
  std::string valve, kind, species;
  PlanOption plan;
  PhysiologyOptions study;
  bool json = false;
};

TableRows table_of(const Physiology& physiology) {
  TableRows rows = {{"quantity", "value", "low", "high", "unit", "verdict"}};
  for (const PhysiologyRow& row : physiology.rows)
    rows.push_back({row.quantity->what, figure_cell(row.value),
                    row.range != nullptr ? figure_cell(row.range->low) : "",
                    row.range != nullptr ? figure_cell(row.range->high) : "", row.quantity->unit,
                    to_string(row.verdict)});
  return rows;
}

void print_physiology(const Physiology& physiology, const std::string& name) {
  std::cout << name << ": " << to_string(physiology.kind)
            << (physiology.kind_judged ? " (judged), " : ", ") << to_string(physiology.species)
            << (physiology.species_judged ? " (judged)" : "") << "\n\n";
  print_table(std::cout, table_of(physiology));
  int met = 0, with_range = 0;
  for (const PhysiologyRow& row : physiology.rows) {
    if (row.range != nullptr) ++with_range;
    if (row.verdict == PhysiologyVerdict::Met) ++met;
  }
  std::cout << '\n' << met << " of " << with_range << " ranges met. Sources: --json\n";
}

int run(StudyPhysiologyArguments arguments) {
  const PlannedValve given = read_planned_valve(arguments.valve, arguments.plan);
  if (given.failed) return given.failed;
  for (const ValveKind kind : kValveKinds)
    if (arguments.kind == to_string(kind)) arguments.study.kind = kind;
  for (const Species species : kSpecies)
    if (arguments.species == to_string(species)) arguments.study.species = species;
  const auto study_it = [&] {
    const ProgressBar bar;
    arguments.study.progress = [&](int done, int planned) { bar.show(done, planned, "trials"); };
    return study_physiology(given.repaired, arguments.study);
  };
  const Physiology physiology = study_it();
  if (arguments.json)
    std::cout << to_json(physiology, given.repaired).dump(2) << '\n';
  else
    print_physiology(physiology, given.valve.name);
  const bool closed = std::isfinite(physiology.rows.front().value);
  return closed ? exit_code::kOk : exit_code::kNotClosed;
}

template <class Names>
std::vector<std::string> names_of(const Names& values) {
  std::vector<std::string> names;
  for (const auto value : values) names.emplace_back(to_string(value));
  return names;
}

}  // namespace

void add_study_physiology(Command parent, int& status) {
  const auto arguments = std::make_shared<StudyPhysiologyArguments>();
  Command command = parent.add_command(
      "physiology", "Loads, strains, rings, opening and clips beside what was measured in hearts");
  command.add_option("valve", arguments->valve, kValveHelp).required();
  add_plan_option(command, arguments->plan);
  command
      .add_option("--kind", arguments->kind,
                  "Whose ranges hold; left out: healthy below 5 mm2 of leak, else prolapse where "
                  "chordae are ruptured or leaflets billow, else functional")
      .one_of(names_of(kValveKinds));
  command
      .add_option("--species", arguments->species,
                  "Whose ranges hold; left out: porcine if the valve's name says so, else human")
      .one_of(names_of(kSpecies));
  command
      .add_option("--threads", arguments->study.threads, "0: all cores; does not change the answer")
      .check(number_from(0, 1024))
      .show_default();
  command.add_flag("--json", arguments->json, "Print JSON, with the source of each range");
  command.footer(
      "Exit code 3 if the valve did not close. A row is met, below or above its range, unknown (a "
      "closure\nor opening failed), or without a range for this kind of valve.\n\n"
      "Examples:\n"
      "  coapt study physiology human-normal\n"
      "  coapt study physiology valve.json --kind functional --json");
  command.on_run([arguments, &status] { status = run(*arguments); });
}

}  // namespace coapt
