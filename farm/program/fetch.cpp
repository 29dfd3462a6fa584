#include <algorithm>
#include <fstream>
#include <iostream>
#include <memory>

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
};

int fetch(const FetchArguments& arguments) {
  const std::atomic<bool>& interrupted = catch_interrupts();
  if (const int failed = check_output(arguments.output)) return failed;
  Expected<FarmDatabase> database = FarmDatabase::open(arguments.farm.url);
  if (!database) return report_farm_errors(database.errors());
  const auto run = static_cast<std::int64_t>(arguments.run);
  int status = exit_code::kOk;
  if (arguments.wait) status = wait_for_run(*database, run, {}, interrupted);
  if (status != exit_code::kOk && !(status == kHoles && arguments.tasks)) return status;
  if (arguments.output.empty())
    return std::max(status, write_answers(*database, run, arguments.tasks, std::cout, interrupted));
  std::ofstream file(arguments.output, std::ios::binary);
  return std::max(status, write_answers(*database, run, arguments.tasks, file, interrupted));
}

}  // namespace

void add_fetch(Command parent, int& status) {
  const auto arguments = std::make_shared<FetchArguments>();
  Command command = parent.add_command("fetch", "Write the answers of a run");
  add_run_argument(command, arguments->run);
  add_farm_option(command, arguments->farm);
  command.add_option("-o,--output", arguments->output, "Write them here, not to standard output")
      .show_argument("FILE");
  command.add_flag("--wait", arguments->wait, "Wait until the run is done");
  command.add_flag("--tasks", arguments->tasks,
                   "Task by task, each after a line \"FIRST ITEMS BYTES\"; a run with holes, too");
  command.footer(
      "Examples:\n"
      "  coapt-farm fetch 3 > answers.bin\n"
      "  coapt-farm fetch 3 --wait -o answers.bin");
  command.on_run([arguments, &status] { status = fetch(*arguments); });
}

}  // namespace coapt
