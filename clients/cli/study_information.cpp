#include <cmath>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "clients/cli/commands.h"
#include "clients/cli/plan_option.h"
#include "clients/cli/print.h"
#include "clients/cli/print_table.h"
#include "clients/cli/read_argument.h"
#include "io/command_line/exit_code.h"
#include "io/command_line/interrupt.h"
#include "io/command_line/progress_bar.h"
#include "io/json/model_study_json.h"
#include "io/picture/text.h"
#include "search/studies/information.h"

namespace coapt {
namespace {

struct StudyInformationArguments {
  std::string valve;
  PlanOption plan;
  ModelStudyOptions study;
  bool json = false;
};

int run(StudyInformationArguments arguments) {
  const std::atomic<bool>& interrupted = catch_interrupts();
  const PlannedValve given = read_planned_valve(arguments.valve, arguments.plan);
  if (given.failed) return given.failed;
  arguments.study.cancelled = &interrupted;
  if (!given.plan.steps.empty()) arguments.study.unrepaired = &given.valve;
  const auto study_it = [&] {
    const ProgressBar bar;
    arguments.study.progress = [&](int done, int planned) {
      if (done % 8 == 0 || done == planned) bar.show(done, planned, "draws");
    };
    return study_model(given.repaired, arguments.study);
  };
  const ModelStudy study = study_it();
  const std::vector<InformationRow> rows = information_rows(study);
  const Json json = to_json(study, rows, given.valve.name);
  if (arguments.json) {
    std::cout << json.dump(2) << '\n';
  } else {
    std::cout << printable(given.valve.name) << ": leak " << leak_and_error(json["leak"])
              << ", over " << draws_words(json) << "\n\n";
    TableRows table = {{"if it were measured", "of the variance goes", "mm2 (sd) remain"}};
    for (const InformationRow& row : rows)
      table.push_back({row.measurement,
                       std::isfinite(row.share_removed) ? percent(row.share_removed) : "n/a",
                       fixed(row.remaining_mm2, 1)});
    print_table(std::cout, table);
  }
  if (interrupted) return exit_code::kInterrupted;
  return trusted(study.as_it_is) ? exit_code::kOk : exit_code::kNotClosed;
}

}  // namespace

void add_study_information(Command parent, int& status) {
  const auto arguments = std::make_shared<StudyInformationArguments>();
  Command command = parent.add_command(
      "information",
      "Which measurement of a valve would say most of its leak, as it is or repaired");
  command.add_option("valve", arguments->valve, kValveHelp).required();
  add_plan_option(command, arguments->plan);
  command
      .add_option("--draws", arguments->study.draws,
                  "Draws of tissue and chordae, closed before and after the plan")
      .check(number_from(1, 100000))
      .show_default();
  command.add_option("--seed", arguments->study.seed, "Seed of the Latin hypercube")
      .check(number_from(std::uint64_t{0}, std::uint64_t{1} << 62))
      .show_default();
  command
      .add_option("--threads", arguments->study.threads, "0: all cores; does not change the answer")
      .check(number_from(0, 1024))
      .show_default();
  command.add_flag("--json", arguments->json, "Print JSON (coapt.information/1)");
  command.footer(
      "The measurements are of the unrepaired valve, with the errors that they name. What was "
      "observed already\n(coapt observe) is counted. Examples:\n"
      "  coapt study information human-functional-mr\n"
      "  coapt study information valve.json --plan ring.json --json");
  command.on_run([arguments, &status] { status = run(*arguments); });
}

}  // namespace coapt
