#include "operations/operations.h"

#include <algorithm>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "clients/cli/ask.h"
#include "clients/cli/commands.h"
#include "clients/cli/read_argument.h"
#include "core/valve/nearest_name.h"
#include "io/command_line/exit_code.h"
#include "io/command_line/files.h"
#include "io/command_line/interrupt.h"
#include "io/json/parse_json.h"
#include "io/json/version.h"
#include "operations/surface_file.h"

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
  std::cout << json_text(Json{{"operations", list}, {"notice", kResearchNotice}}, 2) << '\n';
}

void print_text() {
  for (const Operation& operation : operations()) {
    std::string doors;
    for (const std::string& name : door_names(operation.doors))
      doors += (doors.empty() ? "" : ", ") + name;
    std::cout << operation.name << ": " << operation.what << " (" << doors << ")\n";
  }
}

struct OperationArguments {
  std::string name, request = "-", output = "-";
  ServerOption server;
  bool json = false;
};

Errors no_operation(const std::string& name) {
  std::vector<std::string> names;
  for (const Operation& operation : operations())
    if (operation.read != nullptr) names.emplace_back(operation.name);
  std::string list;
  for (const std::string& known : names) list += (list.empty() ? "" : ", ") + known;
  return {
      Error{ErrorCode::BadReference, "",
            name + " does not take requests; must be one of " + list + did_you_mean(name, names)}};
}

/// A document with line breaks, a file as it is.
std::string printed(const OperationAnswer& answer) {
  if (const auto* const document = std::get_if<Json>(&answer)) {
    Json told = *document;
    told["notice"] = kResearchNotice;
    return json_text(told, 2) + '\n';
  }
  const auto& file = std::get<AnswerFile>(answer);
  if (!file.name.empty() || !file.type.starts_with("application/json")) return file.bytes;
  return json_text(Json::parse(file.bytes, nullptr, false), 2) + '\n';
}

/// The answer to a request as it is, of any operation.
int run_request(const OperationArguments& arguments, const std::optional<Service>& service) {
  const std::vector<Operation> all = operations();
  const bool known = std::any_of(all.begin(), all.end(), [&](const Operation& one) {
    return one.read != nullptr && arguments.name == one.name;
  });
  if (!known) return report_errors("operations", no_operation(arguments.name));
  if (const int failed = check_output(arguments.output == "-" ? "" : arguments.output))
    return failed;
  const Expected<std::string> text = read_input(arguments.request);
  if (!text) return report_errors(arguments.request, text.errors());
  const Expected<Json> request = parse_json(*text);
  if (!request) return report_errors(arguments.request, request.errors());
  Context here{.limits = OperationLimits::unlimited(),
               .valve_named = read_any_valve_argument,
               .surface_of = read_surface_file,
               .interrupted = &catch_interrupts()};
  const auto answer = ask(service, arguments.name.c_str(), *request, here);
  if (!answer) return report_errors(arguments.request, answer.errors());
  return write_output(arguments.output, printed(*answer));
}

}  // namespace

void add_operations(Command parent, int& status) {
  const auto arguments = std::make_shared<OperationArguments>();
  Command command = parent.add_command(
      "operations", "List all operations and the interfaces that offer them, or run one by name");
  command.add_option("name", arguments->name,
                     "Operation to run on the request of --request (default: list all)");
  command
      .add_option("--request", arguments->request,
                  "Request of the operation, as in the API of the service (JSON), - for standard "
                  "input")
      .show_default();
  command.add_option("-o,--output", arguments->output, "File for the answer, - for standard output")
      .show_default();
  command.add_flag("--json", arguments->json,
                   "Print the list as JSON, including the command and the service path of each "
                   "operation");
  add_server_option(command, arguments->server);
  command.footer(
      "Interfaces: command_line (this program), service (coapt-server), python (in-process or "
      "through a\nservice), browser (the web page without a service), farm (coapt-farm).\n\n"
      "Examples:\n"
      "  coapt operations\n"
      "  coapt operations --json\n"
      "  coapt operations scene --request request.json -o scene.json");
  on_run_by(command, "operations", arguments->server, {}, status,
            [arguments](const std::optional<Service>& service) {
              if (!arguments->name.empty()) return run_request(*arguments, service);
              arguments->json ? print_json() : print_text();
              return exit_code::kOk;
            });
}

}  // namespace coapt
