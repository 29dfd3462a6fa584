#include <algorithm>
#include <fstream>
#include <iostream>
#include <memory>
#include <optional>

#include "farm/program/commands.h"
#include "farm/program/farm_option.h"
#include "farm/program/wait_for_run.h"
#include "io/command_line/exit_code.h"
#include "io/command_line/files.h"
#include "io/command_line/interrupt.h"

namespace coapt {
namespace {

struct FetchArguments {
  FarmOption farm;
  std::uint64_t run = 0;
  std::string output;
  bool tasks = false, wait = false;
  int recompute = -1;  ///< tasks; as the kind of work asks
};

int fetch(const FetchArguments& arguments, const FarmKinds& kinds) {
  const std::atomic<bool>& interrupted = catch_interrupts();
  if (const int failed = check_output(arguments.output)) return failed;
  Expected<FarmDatabase> database = FarmDatabase::open(arguments.farm.url);
  if (!database) return report_farm_errors(database.errors());
  const auto run = static_cast<std::int64_t>(arguments.run);
  int status = exit_code::kOk;
  const Expected<RunRequest> request = database->request(run);
  if (!request) return report_farm_errors(request.errors());
  AskedRun asked{run, request->work};
  std::optional<Expected<Work>> work;
  if (request->revision == kinds.revision)
    work = kinds.open(request->request);
  else
    say("the run is of revision " + request->revision +
        ", which this program cannot check; it is " + kinds.revision);
  if (work && !*work) return report_farm_errors(work->errors());
  if (work) {
    asked.check = &**work;
    asked.sampled = arguments.recompute < 0 ? (*work)->sampled_tasks : arguments.recompute;
  }
  status = arguments.wait ? wait_and_check(*database, asked, {}, interrupted)
                          : check_answers(*database, asked, false, interrupted);
  if (status != exit_code::kOk && !(status == kHoles && arguments.tasks)) return status;
  if (arguments.output.empty())
    return std::max(status,
                    write_answers(*database, asked, arguments.tasks, std::cout, interrupted));
  std::ofstream file(arguments.output, std::ios::binary);
  return std::max(status, write_answers(*database, asked, arguments.tasks, file, interrupted));
}

}  // namespace

void add_fetch(Command parent, int& status, const FarmKinds& kinds) {
  const auto arguments = std::make_shared<FetchArguments>();
  Command command = parent.add_command("fetch", "Write the results of a run");
  add_run_argument(command, arguments->run);
  add_farm_option(command, arguments->farm);
  command
      .add_option("-o,--output", arguments->output,
                  "Write the results to this file instead of standard output")
      .show_argument("FILE");
  command.add_flag("--wait", arguments->wait, "Wait until the run is done");
  add_recompute_option(command, arguments->recompute);
  command.add_flag(
      "--tasks", arguments->tasks,
      "Write each task after a line \"FIRST ITEMS BYTES\"; also for an incomplete run");
  command.footer(
      "Examples:\n"
      "  coapt-farm fetch 3 > answers.bin\n"
      "  coapt-farm fetch 3 --wait -o answers.bin");
  command.on_run([arguments, kinds, &status] { status = fetch(*arguments, kinds); });
}

}  // namespace coapt
