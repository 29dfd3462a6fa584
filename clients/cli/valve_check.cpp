#include <iostream>
#include <memory>
#include <string>

#include "clients/cli/commands.h"
#include "clients/cli/read_argument.h"
#include "core/valve/printable.h"
#include "io/command_line/exit_code.h"
#include "io/json/result_json.h"

namespace coapt {
namespace {

struct ValveCheckArguments {
  std::string valve;
  bool json = false;
};

int run(const ValveCheckArguments& arguments) {
  const Expected<Valve> valve = read_any_valve_argument(arguments.valve);
  const Errors problems = valve ? Errors{} : valve.errors();
  if (arguments.json) {
    std::cout << json_text(Json{{"problems", to_json(problems)}}, 2) << '\n';
  } else {
    for (const Error& problem : problems) {
      std::cout << printable(problem.path.empty() ? arguments.valve : problem.path) << ": "
                << printable(problem.message) << '\n';
    }
    if (problems.empty()) std::cerr << printable(arguments.valve) << ": no problems\n";
  }
  return problems.empty() ? exit_code::kOk : exit_code::kBadInput;
}

}  // namespace

void add_valve_check(Command parent, int& status) {
  const auto arguments = std::make_shared<ValveCheckArguments>();
  Command command = parent.add_command("check", "List every problem of a valve file");
  command.add_option("valve", arguments->valve, kValveHelp).required();
  command.add_flag("--json", arguments->json,
                   "Print the problems as JSON: {\"problems\": [{\"path\", \"message\"}]}");
  command.footer(
      "Exit code 2 if there is any problem; path is a JSON pointer, empty for the whole file.\n\n"
      "Examples:\n"
      "  coapt valve check valve.json\n"
      "  coapt valve make human-normal -o - | coapt valve check - --json");
  command.on_run([arguments, &status] { status = run(*arguments); });
}

}  // namespace coapt
