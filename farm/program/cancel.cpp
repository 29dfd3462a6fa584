#include <iostream>
#include <memory>

#include "farm/program/commands.h"
#include "farm/program/farm_option.h"
#include "io/command_line/exit_code.h"

namespace coapt {
namespace {

struct RunArguments {
  FarmOption farm;
  std::uint64_t run = 0;
  bool json = false;
};

int cancel(const RunArguments& arguments) {
  Expected<FarmDatabase> database = FarmDatabase::open(arguments.farm.url);
  if (!database) return report_farm_errors(database.errors());
  const Expected<std::string> state = database->cancel(static_cast<std::int64_t>(arguments.run));
  if (!state) return report_farm_errors(state.errors());
  if (arguments.json)
    std::cout << "{\"run\": " << arguments.run << ", \"state\": \"" << *state << "\"}\n";
  else
    std::cout << "run " << arguments.run << ": " << *state << '\n';
  return exit_code::kOk;
}

int forget(const RunArguments& arguments) {
  Expected<FarmDatabase> database = FarmDatabase::open(arguments.farm.url);
  if (!database) return report_farm_errors(database.errors());
  const Errors errors = database->forget(static_cast<std::int64_t>(arguments.run));
  return errors.empty() ? exit_code::kOk : report_farm_errors(errors);
}

}  // namespace

void add_cancel(Command parent, int& status) {
  const auto arguments = std::make_shared<RunArguments>();
  Command command = parent.add_command("cancel", "Stop assigning tasks of a run to workers");
  add_run_argument(command, arguments->run);
  add_farm_option(command, arguments->farm);
  command.add_flag("--json", arguments->json, "Print JSON");
  command.footer(
      "Results so far are kept; submit the request again to resume the run.\n\n"
      "Examples:\n"
      "  coapt-farm cancel 3");
  command.on_run([arguments, &status] { status = cancel(*arguments); });
}

void add_forget(Command parent, int& status) {
  const auto arguments = std::make_shared<RunArguments>();
  Command command = parent.add_command("forget", "Remove a run with its results and valves");
  add_run_argument(command, arguments->run);
  add_farm_option(command, arguments->farm);
  command.footer(
      "An open run must be cancelled first. Valves used by other runs are kept.\n\n"
      "Examples:\n"
      "  coapt-farm forget 3");
  command.on_run([arguments, &status] { status = forget(*arguments); });
}

}  // namespace coapt
