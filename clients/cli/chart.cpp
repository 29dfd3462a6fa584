#include <filesystem>
#include <iostream>
#include <memory>
#include <string>

#include "clients/cli/commands.h"
#include "clients/cli/exit_code.h"
#include "clients/cli/files.h"
#include "clients/cli/progress_bar.h"
#include "io/picture/accuracy_chart.h"

namespace coapt {
namespace {

int run_speed_accuracy(const std::string& directory) {
  std::error_code failed;
  std::filesystem::create_directories(directory, failed);
  const std::filesystem::path base = std::filesystem::path(directory) / "speed-accuracy";
  if (const int error = check_output(base.string() + ".csv")) return error;
  const std::vector<AccuracyPoint> points = [] {
    const ProgressBar bar;
    return study_accuracy({}, [&](int done, int planned) { bar.show(done, planned, "cases"); });
  }();
  for (const auto& [file, text] :
       {std::pair(base.string() + ".csv", accuracy_csv(points)),
        std::pair(base.string() + ".svg", accuracy_svg(points)),
        std::pair(base.string() + "-orifice.svg", orifice_error_svg(points))})
    if (const int error = write_output(file, text)) return error;
  return exit_code::kOk;
}

}  // namespace

void add_chart(CLI::App& parent, int& status) {
  CLI::App* chart =
      parent.add_subcommand("chart", "Draw speed against accuracy")->require_subcommand(1);
  const auto directory = std::make_shared<std::string>("charts");
  CLI::App* command = chart->add_subcommand(
      "speed-accuracy", "Close two presets by each method, membrane, resolution and tolerance");
  command->add_option("-o,--output", *directory, "Directory for the CSV and the charts")
      ->capture_default_str();
  command->footer(
      "Errors are against one reference a scene: membrane continuum, 5,200 triangles, residual "
      "1e-6.\n"
      "Takes a few minutes on one core; times are of this machine.\n\n"
      "Example:\n"
      "  coapt chart speed-accuracy -o charts");
  command->callback([directory, &status] { status = run_speed_accuracy(*directory); });
}

}  // namespace coapt
