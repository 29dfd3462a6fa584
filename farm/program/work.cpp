#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdlib>
#include <iostream>
#include <memory>

#include "farm/database/worker.h"
#include "farm/program/commands.h"
#include "farm/program/farm_option.h"
#include "io/command_line/exit_code.h"
#include "io/command_line/interrupt.h"
#include "io/json/json.h"
#include "io/picture/text.h"

namespace coapt {
namespace {

struct WorkArguments {
  FarmOption farm;
  WorkerOptions worker;
  bool json = false, quiet = false;
};

std::string host_name() {
  std::array<char, 256> name{};
  return gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "unknown";
}

const char* word_of(WorkerEnd end) {
  switch (end) {
    case WorkerEnd::Dry:
      return "dry";
    case WorkerEnd::TimeLimit:
      return "time_limit";
    case WorkerEnd::Stopped:
      return "stopped";
    case WorkerEnd::Refused:
      return "refused";
  }
  return "";
}

void print_report(const WorkArguments& arguments, const WorkerReport& report) {
  if (arguments.json) {
    const Json told = {{"schema", "coapt.farm-worker/1"}, {"worker", arguments.worker.name.name},
                       {"end", word_of(report.end)},      {"tasks", report.tasks},
                       {"items", report.items},           {"computing_s", report.computing_s},
                       {"seconds", report.seconds}};
    std::cout << json_text(told, 2) << '\n';
  } else if (!arguments.quiet) {
    say(arguments.worker.name.name + ": " + grouped(report.items) + " items in " +
        counted(static_cast<long>(report.tasks), "task") + ", " + fixed(report.computing_s, 1) +
        " of " + fixed(report.seconds, 1) + " s in computing");
  }
}

int exit_code_of(WorkerEnd end) {
  if (end == WorkerEnd::Refused) return exit_code::kFailure;
  // A scheduler that takes the machine back (SIGTERM) is no failure; Ctrl-C is told to the shell.
  return end == WorkerEnd::Stopped && caught_signal() == SIGINT ? exit_code::kInterrupted
                                                                : exit_code::kOk;
}

int work(WorkArguments& arguments, const FarmKinds& kinds) {
  const std::atomic<bool>& interrupted = catch_interrupts();
  WorkerName& name = arguments.worker.name;
  name.host = host_name();
  name.pid = getpid();
  name.revision = kinds.revision;
  if (name.name.empty()) name.name = name.host + '-' + std::to_string(name.pid);
  Expected<FarmDatabase> database = FarmDatabase::open(arguments.farm.url);
  if (!database) return report_farm_errors(database.errors());
  const auto tell = [&](const std::string& line) {
    if (!arguments.quiet) say(name.name + ": " + line);
  };
  const WorkerReport report =
      run_worker(*database, kinds.open, arguments.worker, interrupted, tell);
  print_report(arguments, report);
  report_farm_errors(report.errors);
  const int status = exit_code_of(report.end);
  if (report.let_go) {
    std::cout.flush();
    std::_Exit(status);  // a task is still being computed
  }
  return status;
}

}  // namespace

void add_work(Command parent, int& status, const FarmKinds& kinds) {
  const auto arguments = std::make_shared<WorkArguments>();
  WorkerOptions& worker = arguments->worker;
  Command command = parent.add_command("work", "Run a worker of the farm");
  add_farm_option(command, arguments->farm);
  command
      .add_option("--threads", worker.threads,
                  "Number of threads per task; does not change results")
      .check(number_from(1, 1024))
      .show_default();
  command.add_flag("--until-dry", worker.until_dry,
                   "Exit when no open run is left for this worker");
  command
      .add_option("--seconds", worker.seconds,
                  "Exit before this time has passed and return unfinished tasks (0: no limit)")
      .check(number_from(0.0, 1e9))
      .show_default();
  command
      .add_option("--grace", worker.grace_s,
                  "Grace period, s, for a task in progress when the worker is stopped")
      .check(number_from(0.0, 3600.0))
      .show_default();
  command.add_option("--name", worker.name.name,
                     "Name of the worker (default: host name and process number)");
  command
      .add_option("--lease", worker.name.lease_s,
                  "Seconds without a heartbeat after which the tasks go to other workers")
      .check(number_from(0.5, 3600.0))
      .show_default();
  command.add_flag("--quiet", arguments->quiet, "Print errors only");
  command.add_flag("--json", arguments->json, "Print a summary as JSON");
  command.footer(
      "Any number of workers may join and leave. On SIGTERM or Ctrl-C a worker submits finished "
      "items and\nreturns the rest. The tasks of a killed worker go to others. A worker skips runs "
      "that require\nanother revision of coapt.\n\n"
      "Examples:\n"
      "  coapt-farm work --db postgresql://anna@db.example/farm --threads 4\n"
      "  coapt-farm work --until-dry --seconds 3500");
  command.on_run([arguments, kinds, &status] { status = work(*arguments, kinds); });
}

}  // namespace coapt
