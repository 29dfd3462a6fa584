#include "operations/operations.h"

#include <iostream>
#include <memory>
#include <string>

#include "clients/cli/commands.h"
#include "io/command_line/exit_code.h"
#include "io/json/version.h"

namespace coapt {
namespace {

void print_json() {
  Json list = Json::array();
  for (const Operation& operation : operations()) {
    const auto or_null = [](const std::string& text) { return text.empty() ? Json() : Json(text); };
    list.push_back({{"name", operation.name},
                    {"what", operation.what},
                    {"command", or_null(operation.command)},
                    {"path", or_null(operation.path)},
                    {"doors", door_names(operation.doors)},
                    {"needs_store", operation.needs_store}});
  }
  std::cout << Json{{"operations", list}, {"notice", kResearchNotice}}.dump(2) << '\n';
}

void print_text() {
  for (const Operation& operation : operations()) {
    std::string doors;
    for (const std::string& name : door_names(operation.doors))
      doors += (doors.empty() ? "" : ", ") + name;
    std::cout << operation.name << ": " << operation.what << " (" << doors << ")\n";
  }
}

}  // namespace

void add_operations(Command parent, int& status) {
  const auto json = std::make_shared<bool>(false);
  Command command =
      parent.add_command("operations", "List all operations and the interfaces that offer them");
  command.add_flag("--json", *json,
                   "Print JSON, including the command and the service path of each operation");
  command.footer(
      "Interfaces: command_line (this program), service (coapt-server), python (in-process or "
      "through a\nservice), browser (the web page without a service), farm (coapt-farm).\n\n"
      "Examples:\n  coapt operations\n  coapt operations --json");
  command.on_run([json, &status] {
    *json ? print_json() : print_text();
    status = exit_code::kOk;
  });
}

}  // namespace coapt
