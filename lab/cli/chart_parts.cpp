#include "lab/cli/chart_parts.h"

#include <filesystem>

#include "io/command_line/exit_code.h"
#include "io/command_line/files.h"
#include "lab/cli/draw.h"

namespace coapt {

int run_chart(const std::string& directory, const std::string& name,
              const std::function<std::string()>& make) {
  std::error_code failed;
  std::filesystem::create_directories(directory, failed);
  const std::filesystem::path table = std::filesystem::path(directory) / name;
  if (const int error = check_output(table.string())) return error;
  if (const int error = write_output(table.string(), make())) return error;
  draw(table);
  return exit_code::kOk;
}

std::shared_ptr<std::string> add_output(Command command) {
  const auto directory = std::make_shared<std::string>("charts");
  command.add_option("-o,--output", *directory, "Directory for the CSV file and its charts")
      .show_default();
  return directory;
}

void add_threads_option(Command command, int& threads, const std::string& what) {
  command
      .add_option("--threads", threads,
                  "Number of threads (0: all cores); does not change the " + what)
      .check(number_from(0, 1024))
      .show_default();
}

}  // namespace coapt
