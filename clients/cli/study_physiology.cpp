#include <iostream>
#include <memory>
#include <optional>
#include <string>

#include "clients/cli/ask.h"
#include "clients/cli/commands.h"
#include "clients/cli/plan_option.h"
#include "clients/cli/read_argument.h"
#include "clients/cli/run_options.h"
#include "core/valve/printable.h"
#include "io/command_line/exit_code.h"
#include "io/command_line/files.h"
#include "io/command_line/progress_bar.h"
#include "io/json/physiology_json.h"
#include "io/picture/text_table.h"

namespace coapt {
namespace {

struct StudyPhysiologyArguments {
  std::string valve, kind, species;
  PlanOption plan;
  ServerOption server;
  int threads = 0;
  bool json = false;
};

std::string figure_of(const Json& figure) {
  return figure.is_null() ? "" : figure_cell(figure.get<double>());
}

/// Of coapt.physiology/1.
void print_physiology(const Json& physiology) {
  const auto judged = [&](const std::string& name) {
    return physiology[name].get<std::string>() +
           (physiology[name + "_judged"].get<bool>() ? " (inferred)" : "");
  };
  std::cout << printable(physiology["valve"].get<std::string>()) << ": " << judged("kind") << ", "
            << judged("species") << "\n\n";
  TableRows table = {{"quantity", "value", "low", "high", "unit", "verdict"}};
  int met = 0, with_range = 0;
  for (const Json& row : physiology["rows"]) {
    table.push_back({row["what"], row["value"].is_null() ? "-" : figure_of(row["value"]),
                     figure_of(row["low"]), figure_of(row["high"]), row["unit"], row["verdict"]});
    if (!row["low"].is_null()) ++with_range;
    if (row["verdict"] == to_string(PhysiologyVerdict::Met)) ++met;
  }
  print_table(std::cout, table);
  std::cout << '\n'
            << met << " of " << with_range
            << " quantities are within their ranges. Use --json for the sources.\n";
}

int run(const StudyPhysiologyArguments& arguments, const std::optional<Service>& service) {
  AskedRequest asked = asked_repair(arguments.valve, arguments.plan, service);
  if (asked.failed) return asked.failed;
  if (!arguments.kind.empty()) asked.request["kind"] = arguments.kind;
  if (!arguments.species.empty()) asked.request["species"] = arguments.species;
  asked.here.limits.threads = arguments.threads;
  const auto study_it = [&] {
    const ProgressBar bar;
    asked.here.progress = [&](int done, int planned) { bar.show(done, planned, "trials"); };
    return ask_document(service, "physiology", asked.request, asked.here);
  };
  const Expected<Json> physiology = study_it();
  if (!physiology) return report_refusal("study physiology", physiology.errors(), asked.sources);
  if (arguments.json)
    std::cout << json_text(*physiology, 2) << '\n';
  else
    print_physiology(*physiology);
  const bool closed = !(*physiology)["rows"].front()["value"].is_null();
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
      "physiology", "Compare loads, strains, rings, opening and clips with published measurements");
  command.add_option("valve", arguments->valve, kValveHelp).required();
  add_plan_option(command, arguments->plan);
  command
      .add_option("--kind", arguments->kind,
                  "Kind of valve whose ranges apply (default: healthy if the leak is below 5 mm2, "
                  "else prolapse if chordae are ruptured or leaflets billow, else functional)")
      .one_of(names_of(kValveKinds));
  command
      .add_option("--species", arguments->species,
                  "Species whose ranges apply (default: porcine if the name of the valve says so, "
                  "else human)")
      .one_of(names_of(kSpecies));
  add_threads_option(command, arguments->threads);
  command.add_flag("--json", arguments->json, "Print JSON, including the source of each range");
  add_server_option(command, arguments->server);
  command.footer(
      "A quantity is within (met), below or above its range, unknown (a closure or opening "
      "failed), or has\nno range for this kind of valve. The exit code is 3 if the closure did not "
      "converge.\n\n"
      "Examples:\n"
      "  coapt study physiology human-normal\n"
      "  coapt study physiology valve.json --kind functional --json");
  on_run_by(command, "study physiology", arguments->server, {"--threads"}, status,
            [arguments](const auto& service) { return run(*arguments, service); });
}

}  // namespace coapt
