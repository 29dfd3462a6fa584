#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "clients/cli/ask.h"
#include "clients/cli/commands.h"
#include "clients/cli/plan_option.h"
#include "clients/cli/print.h"
#include "clients/cli/read_argument.h"
#include "clients/cli/result_exit_code.h"
#include "clients/cli/run_options.h"
#include "io/command_line/exit_code.h"
#include "io/command_line/files.h"
#include "io/command_line/interrupt.h"
#include "io/command_line/progress_bar.h"
#include "io/json/model_study_json.h"
#include "io/picture/text.h"
#include "io/picture/text_table.h"
#include "search/studies/model_study.h"

namespace coapt {
namespace {

struct StudyInformationArguments {
  std::string valve;
  PlanOption plan;
  ServerOption server;
  ModelStudyOptions study;
  bool json = false;
};

/// Of coapt.information/1.
void print_information(const Json& information) {
  std::cout << printable(information["valve"].get<std::string>()) << ": leak "
            << leak_and_error(information["leak"]) << ", over " << draws_words(information)
            << "\n\n";
  TableRows table = {{"measurement", "variance removed", "remaining sd, mm2"}};
  for (const Json& row : information["rows"])
    table.push_back(
        {row["measurement"],
         row["share_removed"].is_null() ? "n/a" : percent(row["share_removed"].get<double>()),
         row["remaining_mm2"].is_null() ? "n/a" : fixed(row["remaining_mm2"].get<double>(), 1)});
  print_table(std::cout, table);
}

int run(const StudyInformationArguments& arguments, const std::optional<Service>& service) {
  const std::atomic<bool>& interrupted = catch_interrupts();
  AskedRequest asked = asked_repair(arguments.valve, arguments.plan, service);
  if (asked.failed) return asked.failed;
  asked.request["draws"] = arguments.study.draws;
  asked.request["seed"] = arguments.study.seed;
  asked.here.limits.threads = arguments.study.threads;
  asked.here.interrupted = &interrupted;
  const auto study_it = [&] {
    const ProgressBar bar;
    asked.here.progress = [&](int done, int planned) {
      if (done % 8 == 0 || done == planned) bar.show(done, planned, "draws");
    };
    return ask_document(service, "information", asked.request, asked.here);
  };
  const Expected<Json> information = study_it();
  if (!information) return report_refusal("study information", information.errors(), asked.sources);
  if (arguments.json)
    std::cout << json_text(*information, 2) << '\n';
  else
    print_information(*information);
  if (interrupted) return exit_code::kInterrupted;
  return exit_code_of_closure(*information);
}

}  // namespace

void add_study_information(Command parent, int& status) {
  const auto arguments = std::make_shared<StudyInformationArguments>();
  Command command = parent.add_command(
      "information",
      "Rank measurements by how much they would reduce the tissue error of the leak");
  command.add_option("valve", arguments->valve, kValveHelp).required();
  add_plan_option(command, arguments->plan);
  command
      .add_option("--draws", arguments->study.draws,
                  "Number of variants of tissue and chordae, closed before and after the plan")
      .check(number_from(1, 100000))
      .show_default();
  add_seed_option(command, arguments->study.seed, "Seed of the Latin hypercube");
  add_threads_option(command, arguments->study.threads);
  command.add_flag("--json", arguments->json, "Print JSON (coapt.information/1)");
  add_server_option(command, arguments->server);
  command.footer(
      "Measurements are of the unrepaired valve and have the errors stated with them. Observations "
      "already\nstored (coapt observe) are taken into account.\n\nExamples:\n"
      "  coapt study information human-functional-mr\n"
      "  coapt study information valve.json --plan ring.json --json");
  on_run_by(command, "study information", arguments->server, {"--threads"}, status,
            [arguments](const auto& service) { return run(*arguments, service); });
}

}  // namespace coapt
