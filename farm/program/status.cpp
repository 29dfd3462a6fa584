#include <unistd.h>

#include <iostream>
#include <memory>

#include "farm/program/commands.h"
#include "farm/program/persistence.h"
#include "farm/program/status_text.h"
#include "io/command_line/interrupt.h"
#include "io/json/json.h"

namespace coapt {
namespace {

struct StatusArguments {
  FarmOption farm;
  bool json = false, prometheus = false, watch = false;
};

void print(const Json& status, const StatusArguments& arguments) {
  if (arguments.json)
    std::cout << json_text(status, 2) << '\n';
  else if (arguments.prometheus)
    print_prometheus(std::cout, status);
  else
    print_farm(std::cout, status);
}

int show_status(const StatusArguments& arguments) {
  const std::atomic<bool>& interrupted = catch_interrupts();
  Expected<FarmDatabase> database = FarmDatabase::open(arguments.farm.url);
  if (!database) return report_farm_errors(database.errors());
  for (;;) {
    int status = exit_code::kOk;
    const auto text =
        persistently(*database, interrupted, false, status, [&] { return database->status(); });
    if (!text) return status;
    if (arguments.watch && isatty(STDOUT_FILENO) == 1) std::cout << "\033[H\033[J";
    print(Json::parse(*text), arguments);
    if (!arguments.watch || interrupted) return exit_code::kOk;
    std::cout << std::flush;
    sleep_unless(std::chrono::seconds(2), interrupted);
    if (interrupted) return exit_code::kOk;
  }
}

}  // namespace

void add_status(Command parent, int& status) {
  const auto arguments = std::make_shared<StatusArguments>();
  Command command = parent.add_command("status", "Show runs and workers");
  add_farm_option(command, arguments->farm);
  command.add_flag("--json", arguments->json, "Print JSON (coapt.farm/1)");
  command
      .add_flag("--prometheus", arguments->prometheus,
                "Print metrics in the Prometheus text format")
      .excludes("--json");
  command.add_flag("--watch", arguments->watch, "Repeat every 2 s until Ctrl-C")
      .excludes("--json")
      .excludes("--prometheus");
  command.footer(
      "An item is done once its result is accepted; rates are averages over the last minute.\n\n"
      "Examples:\n"
      "  coapt-farm status --watch\n"
      "  coapt-farm status --prometheus > /var/lib/node_exporter/coapt.prom.new");
  command.on_run([arguments, &status] { status = show_status(*arguments); });
}

}  // namespace coapt
