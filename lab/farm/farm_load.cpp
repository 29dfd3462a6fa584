// A farm under load: as many workers as are asked for, each a thread with the real worker's loop and a connection of its own, whose
// tasks take a given time and answer bytes that do not compress. Prints JSON: how much of the workers' time went into tasks, tasks a
// second, and what the database grew by.
//
// The workers share the machine with the database: tasks of 0 ms measure both.
#include <atomic>
#include <chrono>
#include <exception>
#include <iostream>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "clients/cli/exit_code.h"
#include "farm/database/worker.h"
#include "io/command_line/command_line.h"

namespace coapt {
namespace {

using Clock = std::chrono::steady_clock;
using Json = nlohmann::ordered_json;

constexpr const char* kRevision = "farm_load";

struct LoadArguments {
  std::string url;
  int workers = 64, task_items = 256, item_bytes = 17;
  std::uint64_t tasks = 512;
  double task_ms = 1800.0, check_share = 0.0;
};

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

Work sleeping_work(const LoadArguments& arguments) {
  Work work;
  work.compute = [arguments](std::int64_t first, int count, int) {
    std::this_thread::sleep_for(std::chrono::duration<double, std::milli>(arguments.task_ms));
    std::string bytes(static_cast<std::size_t>(count * arguments.item_bytes), '\0');
    std::uint64_t state = static_cast<std::uint64_t>(first);
    for (char& byte : bytes) {
      state = state * 6364136223846793005u + 1442695040888963407u;  // Knuth's MMIX
      byte = static_cast<char>(state >> 56);
    }
    return bytes;
  };
  return work;
}

int fail(const Errors& errors) {
  for (const Error& error : errors) std::cerr << "farm_load: " << error.message << '\n';
  return exit_code::kFailure;
}

Expected<std::int64_t> database_bytes(FarmDatabase& database) {
  const Expected<std::string> status = database.status();
  if (!status) return status.errors();
  return Json::parse(*status)["database_bytes"].get<std::int64_t>();
}

int load(const LoadArguments& arguments) {
  Expected<FarmDatabase> database = FarmDatabase::open(arguments.url);
  if (!database) return fail(database.errors());
  const Expected<std::int64_t> before = database_bytes(*database);
  if (!before) return fail(before.errors());
  const auto items = static_cast<std::int64_t>(arguments.tasks) * arguments.task_items;
  // A run of its own each time.
  const std::string name = std::to_string(Clock::now().time_since_epoch().count());
  Clock::time_point start = Clock::now();
  const Expected<std::int64_t> run = database->add(
      {"load", {name}},
      {name, kRevision, "farm_load", "", items, arguments.task_items, arguments.check_share});
  if (!run) return fail(run.errors());
  const double adding_s = seconds_since(start);

  std::vector<WorkerReport> reports(static_cast<std::size_t>(arguments.workers));
  std::vector<std::thread> threads;
  const std::atomic<bool> stop = false;
  const WorkOpener open = [&](const WorkRequest&) { return sleeping_work(arguments); };
  start = Clock::now();
  for (std::size_t i = 0; i < reports.size(); ++i)
    threads.emplace_back([&, i] {
      Expected<FarmDatabase> own = FarmDatabase::open(arguments.url);
      if (!own) {
        reports[i].errors = own.errors();
        return;
      }
      WorkerOptions options;
      options.name = {"load-" + std::to_string(i), "load", static_cast<int>(i), kRevision};
      options.until_dry = true;
      reports[i] = run_worker(*own, open, options, stop, [](const std::string&) {});
    });
  for (std::thread& thread : threads) thread.join();
  const double seconds = seconds_since(start);

  double computing_s = 0.0, working_s = 0.0;
  std::int64_t tasks = 0;
  for (const WorkerReport& report : reports) {
    if (!report.errors.empty()) return fail(report.errors);
    computing_s += report.computing_s;
    working_s += report.seconds;
    tasks += report.tasks;
  }
  const Expected<std::int64_t> after = database_bytes(*database);
  if (!after) return fail(after.errors());
  const auto count = static_cast<double>(tasks);
  std::cout << Json{{"workers", arguments.workers},
                    {"task_ms", arguments.task_ms},
                    {"task_items", arguments.task_items},
                    {"items", items},
                    {"tasks", tasks},
                    {"adding_s", adding_s},
                    {"seconds", seconds},
                    {"tasks_per_s", count / seconds},
                    {"ms_per_task", 1e3 * seconds / count},
                    {"computing_share", computing_s / working_s},
                    {"bytes_per_item",
                     static_cast<double>(*after - *before) / static_cast<double>(items)}}
                   .dump(2)
            << '\n';
  return exit_code::kOk;
}

int run(int argc, char** argv) {
  CommandLine line("farm_load", "Measures a farm with workers that sleep.", "farm_load");
  Command app = line.program();
  LoadArguments arguments;
  app.add_option("--db", arguments.url, "The farm's database (coapt-farm init)")
      .environment("COAPT_FARM")
      .required();
  app.add_option("--workers", arguments.workers, "How many")
      .check(number_from(1, 1024))
      .show_default();
  app.add_option("--tasks", arguments.tasks, "Of the run")
      .check(number_from(std::uint64_t{1}, std::uint64_t{100'000'000}))
      .show_default();
  app.add_option("--task-ms", arguments.task_ms, "What a task takes")
      .check(number_from(0.0, 1e6))
      .show_default();
  app.add_option("--task-items", arguments.task_items, "Items of a task")
      .check(number_from(1, 1'000'000))
      .show_default();
  app.add_option("--item-bytes", arguments.item_bytes, "Bytes of an item's answer")
      .check(number_from(1, 1'000'000))
      .show_default();
  app.add_option("--check-share", arguments.check_share, "Of tasks that two workers compute")
      .check(number_from(0.0, 1.0))
      .show_default();
  if (const std::optional<int> ended = line.parse(argc, argv)) return *ended;
  return load(arguments);
}

}  // namespace
}  // namespace coapt

int main(int argc, char** argv) {
  try {
    return coapt::run(argc, argv);
  } catch (const std::exception& error) {
    std::cerr << "farm_load: " << error.what() << '\n';
    return coapt::exit_code::kFailure;
  }
}
