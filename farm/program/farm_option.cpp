#include "farm/program/farm_option.h"

#include <cstdint>
#include <iostream>
#include <limits>

#include "io/command_line/exit_code.h"
#include "io/json/result_json.h"
#include "io/picture/text.h"

namespace coapt {

void add_farm_option(Command command, FarmOption& option) {
  command
      .add_option("--db", option.url,
                  "Database of the farm: postgresql://USER@HOST/NAME, or through a socket "
                  "postgresql:///NAME?host=/FOLDER")
      .show_argument("URL")
      .environment("COAPT_FARM")
      .required();
}

void add_run_argument(Command command, std::uint64_t& run) {
  command.add_option("run", run, "Number of the run in coapt-farm status")
      .check(number_from(std::uint64_t{1},
                         static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max())))
      .required();
}

void add_recompute_option(Command command, int& tasks) {
  command
      .add_option(
          "--recompute", tasks,
          "Number of random tasks recomputed here before the results are written (default: "
          "2; for searches 1, in runs of 5 and more); those that look wrong are recomputed besides")
      .check(number_from(0, 1'000'000))
      .show_argument("TASKS");
}

void say(const std::string& message) { std::cerr << "coapt-farm: " + printable(message) + '\n'; }

int report_farm_errors(const Errors& errors, bool json) {
  int status = exit_code::kFailure;
  for (const Error& error : errors) {
    if (error.code == ErrorCode::BadReference) status = exit_code::kBadInput;
    if (json)
      std::cerr << json_text(Json{{"error", to_json(Errors{error})[0]}}) + '\n';
    else
      say((error.path.empty() ? "" : error.path + ": ") + error.message);
  }
  return status;
}

}  // namespace coapt
