#include <iostream>
#include <memory>
#include <optional>
#include <string>

#include "clients/cli/ask.h"
#include "clients/cli/commands.h"
#include "clients/cli/plan_option.h"
#include "clients/cli/read_argument.h"
#include "clients/cli/result_exit_code.h"
#include "clients/cli/run_options.h"
#include "core/valve/printable.h"
#include "io/command_line/command_line.h"
#include "io/command_line/exit_code.h"
#include "io/command_line/files.h"
#include "io/command_line/interrupt.h"
#include "io/command_line/progress_bar.h"
#include "search/studies/model_study.h"

namespace coapt {
namespace {

struct StudyModelArguments {
  std::string valve, directory = "study-model";
  PlanOption plan;
  ServerOption server;
  int draws = ModelStudyOptions{}.draws, threads = 0;
  std::uint64_t seed = 1;
  bool json = false;
};

/// The files of the answer but for its summary, and the answer. Returns an exit code.
int write_all(const std::string& directory, const Json& files, const Json& study) {
  const auto write = [&](const std::string& name, const std::string& content) {
    return write_output(directory + "/" + name, content);
  };
  if (const int failed = write("model.json", study.dump(2) + "\n")) return failed;
  for (const Json& file : files)
    if (file["name"] != "summary.txt")
      if (const int failed = write(file["name"], file["text"])) return failed;
  return exit_code::kOk;
}

int run(const StudyModelArguments& arguments, const std::optional<Service>& service) {
  const std::atomic<bool>& interrupted = catch_interrupts();
  AskedRequest asked = asked_repair(arguments.valve, arguments.plan, service);
  if (asked.failed) return asked.failed;
  if (const Errors errors = make_directory(arguments.directory); !errors.empty()) {
    report_errors("study model", errors);
    return exit_code::kFailure;
  }
  asked.request.update(Json{{"draws", arguments.draws}, {"seed", arguments.seed}, {"files", true}});
  asked.here.limits.threads = arguments.threads;
  asked.here.interrupted = &interrupted;
  const auto study_it = [&] {
    const ProgressBar bar;
    asked.here.progress = [&](int done, int planned) {
      if (done % 8 == 0 || done == planned) bar.show(done, planned, "closures");
    };
    return ask_document(service, "model", asked.request, asked.here);
  };
  Expected<Json> study = study_it();
  if (!study) return report_refusal("study model", study.errors(), asked.sources);
  const Json files = (*study)["files"];
  study->erase("files");
  if (const int failed = write_all(arguments.directory, files, *study)) return failed;
  if (arguments.json)
    std::cout << json_text(*study, 2) << '\n';
  else
    std::cout << printable_lines(files.back()["text"].get<std::string>()) << "\nWritten to "
              << printable(arguments.directory) << "/index.html\n";
  return interrupted ? exit_code::kInterrupted : exit_code_of_closure(*study);
}

}  // namespace

void add_study_model(Command parent, int& status) {
  const auto arguments = std::make_shared<StudyModelArguments>();
  Command command = parent.add_command(
      "model", "Analyse the sensitivity of the leak to uncertain tissue and chordae");
  command.add_option("valve", arguments->valve, kValveHelp).required();
  add_plan_option(command, arguments->plan);
  command
      .add_option("--draws", arguments->draws, "Number of variants of tissue and chordae to close")
      .check(number_from(1, 100000))
      .show_default();
  add_seed_option(command, arguments->seed, "Seed of the Latin hypercube");
  command.add_option("-o,--output", arguments->directory, "Directory for JSON, CSV and index.html")
      .show_default();
  add_threads_option(command, arguments->threads);
  command.add_flag("--json", arguments->json, "Print JSON");
  add_server_option(command, arguments->server);
  command.footer(
      "Bending rigidity, insertion zones, thickness, moduli, transition strains and chordae vary "
      "within\nthe ranges of their sources, as factors of the valve's own values; half of the "
      "variants lie on\neach side of these. Neochordae keep their length. No farm is used.\n\n"
      "Examples:\n"
      "  coapt study model human-functional-mr -o model\n"
      "  coapt study model valve.json --plan plans.json --rank 2 --draws 128 --json");
  on_run_by(command, "study model", arguments->server, {"--threads"}, status,
            [arguments](const auto& service) { return run(*arguments, service); });
}

}  // namespace coapt
