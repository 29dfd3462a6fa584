#include <filesystem>
#include <iostream>
#include <memory>
#include <string>

#include "clients/cli/commands.h"
#include "clients/cli/exit_code.h"
#include "clients/cli/files.h"
#include "clients/cli/number_option.h"
#include "clients/cli/progress_bar.h"
#include "io/picture/ablation_chart.h"
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

int run_ablation(const std::string& directory, const AblationStudyOptions& options) {
  std::error_code failed;
  std::filesystem::create_directories(directory, failed);
  const std::filesystem::path base = std::filesystem::path(directory) / "ablation";
  if (const int error = check_output(base.string() + ".csv")) return error;
  const std::vector<AblationOutcome> outcomes = [&] {
    const ProgressBar bar;
    return study_ablations(options,
                           [&](int done, int planned) { bar.show(done, planned, "cases"); });
  }();
  for (const auto& [file, text] : {std::pair(base.string() + ".csv", ablation_csv(outcomes)),
                                   std::pair(base.string() + ".svg", ablation_svg(outcomes))})
    if (const int error = write_output(file, text)) return error;
  return exit_code::kOk;
}

void add_ablation(CLI::App& chart, int& status) {
  const auto directory = std::make_shared<std::string>("charts");
  const auto options = std::make_shared<AblationStudyOptions>();
  CLI::App* command = chart.add_subcommand(
      "ablation", "Close four presets with each ingredient of the model taken away or replaced");
  command->add_option("-o,--output", *directory, "Directory for the CSV and the chart")
      ->capture_default_str();
  command
      ->add_option("--variations", options->variations,
                   "Dilated and displaced scenes of each preset, besides itself")
      ->check(number_from(0, 1000))
      ->capture_default_str();
  command
      ->add_option("--repeats", options->repeats,
                   "Timed closures of each, in turn; the median counts")
      ->check(number_from(1, 100))
      ->capture_default_str();
  command->footer(
      "What an ingredient buys (change of orifice and shape against the full model) and costs\n"
      "(time of a whole closure, both measured in turn). Takes a few minutes on one core.\n\n"
      "Example:\n"
      "  coapt chart ablation -o charts");
  command->callback([directory, options, &status] { status = run_ablation(*directory, *options); });
}

}  // namespace

void add_chart(CLI::App& parent, int& status) {
  CLI::App* chart =
      parent
          .add_subcommand("chart",
                          "Draw speed against accuracy, and what the model's ingredients buy")
          ->require_subcommand(1);
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
  add_ablation(*chart, status);
}

}  // namespace coapt
