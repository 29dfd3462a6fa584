#include <fstream>
#include <iostream>
#include <memory>
#include <optional>
#include <sstream>

#include "farm/program/commands.h"
#include "farm/program/farm_option.h"
#include "farm/program/persistence.h"
#include "farm/program/wait_for_run.h"
#include "farm/work/work_file.h"
#include "io/command_line/exit_code.h"
#include "io/command_line/files.h"
#include "io/command_line/interrupt.h"
#include "io/json/json.h"

namespace coapt {
namespace {

struct AddArguments {
  FarmOption farm;
  std::string file, label, team, output;
  double check_share = 1.0 / 64.0;
  int recompute = -1;  ///< tasks; as the kind of work asks
  bool wait = false, json_progress = false, json = false, quiet = false;
};

/// Without the limit that documents have: requests hold valves by the hundred.
Expected<std::string> read_request(const std::string& path) {
  std::ostringstream bytes;
  if (path == "-") {
    bytes << std::cin.rdbuf();
    return std::move(bytes).str();
  }
  std::ifstream file(path, std::ios::binary);
  if (!file) return Error{ErrorCode::InputOutput, "", path + ": cannot be opened"};
  bytes << file.rdbuf();
  return std::move(bytes).str();
}

int report_request(const std::string& file, Errors errors, bool json) {
  if (file != "-")
    for (Error& error : errors) error.message = file + ": " + error.message;
  report_farm_errors(errors, json);
  return exit_code::kBadInput;
}

int hand_out(FarmDatabase& database, const AskedRun& asked, const AddArguments& arguments,
             const std::atomic<bool>& interrupted) {
  if (arguments.output.empty())
    return write_answers(database, asked, false, std::cout, interrupted);
  std::ofstream file(arguments.output, std::ios::binary);
  return write_answers(database, asked, false, file, interrupted);
}

int add(const AddArguments& arguments, const FarmKinds& kinds) {
  const bool json = arguments.json_progress;
  const std::atomic<bool>& interrupted = catch_interrupts();
  if (const int failed = check_output(arguments.output)) return failed;
  const Expected<std::string> bytes = read_request(arguments.file);
  if (!bytes) return report_request("-", bytes.errors(), json);
  const Expected<WorkRequest> request = read_work(*bytes);
  if (!request) return report_request(arguments.file, request.errors(), json);
  const Expected<Work> work = kinds.open(*request);
  if (!work) return report_request(arguments.file, work.errors(), json);
  Expected<FarmDatabase> database = arguments.wait ? open_patiently(arguments.farm.url, interrupted)
                                                   : FarmDatabase::open(arguments.farm.url);
  if (!database) return report_farm_errors(database.errors(), json);
  const NewRun run{kinds.revision, arguments.label,  arguments.team,
                   work->items,    work->task_items, arguments.check_share};
  int status = exit_code::kOk;
  const std::optional<std::int64_t> id = persistently(*database, interrupted, json, status,
                                                      [&] { return database->add(*request, run); });
  if (!id) return status;
  if (arguments.wait) {
    const AskedRun asked{*id, work_id(*request), &*work,
                         arguments.recompute < 0 ? work->sampled_tasks : arguments.recompute};
    status = wait_and_check(*database, asked, {json, arguments.quiet}, interrupted);
    return status == exit_code::kOk ? hand_out(*database, asked, arguments, interrupted) : status;
  }
  if (arguments.json)
    std::cout << json_text(Json{{"run", *id}, {"items", run.items}, {"work_id", work_id(*request)}})
              << '\n';
  else
    std::cout << "run " << *id << ": " << run.items << " items\n";
  return exit_code::kOk;
}

}  // namespace

void add_add(Command parent, int& status, const FarmKinds& kinds) {
  const auto arguments = std::make_shared<AddArguments>();
  Command command = parent.add_command("add", "Submit a run to the farm");
  command.add_option("request", arguments->file, "Request (coapt.work/1), or - for standard input")
      .required();
  add_farm_option(command, arguments->farm);
  command.add_option("--label", arguments->label, "Name of the run in coapt-farm status");
  command
      .add_option("--team", arguments->team,
                  "Restrict the run to workers of this team (coapt-farm init --team)")
      .show_argument("NAME");
  command
      .add_option("--check-share", arguments->check_share,
                  "Fraction of tasks computed by workers of two logins, to compare their results")
      .check(number_from(0.0, 1.0))
      .show_default("0.0156");
  command.add_flag("--wait", arguments->wait, "Wait for the results and write them");
  command
      .add_option("-o,--output", arguments->output,
                  "With --wait: write the results to this file instead of standard output")
      .show_argument("FILE");
  add_recompute_option(command, arguments->recompute);
  command.add_flag("--progress-json", arguments->json_progress,
                   "Print progress and errors on standard error as JSON, one line per second");
  command.add_flag("--quiet", arguments->quiet, "Do not show progress");
  command.add_flag("--json", arguments->json, "Without --wait: print JSON");
  command.footer(
      "Submitting the same request again refers to the same run and returns its results if they "
      "exist.\nA cancelled run resumes, and failed tasks are retried. Ctrl-C ends only the "
      "waiting.\n\n"
      "Examples:\n"
      "  coapt-farm add request.bin --label \"annulus, valve 3\"\n"
      "  coapt-farm add - --wait < request.bin > answers.bin");
  command.on_run([arguments, kinds, &status] { status = add(*arguments, kinds); });
}

}  // namespace coapt
