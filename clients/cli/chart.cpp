#include <algorithm>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "bench/comparators/newton.h"
#include "bench/comparators/xpbd.h"
#include "clients/cli/commands.h"
#include "clients/cli/exit_code.h"
#include "clients/cli/files.h"
#include "clients/cli/number_option.h"
#include "clients/cli/progress_bar.h"
#include "io/picture/ablation_chart.h"
#include "io/picture/accuracy_chart.h"
#include "io/picture/stability_chart.h"

namespace coapt {
namespace {

using Files = std::vector<std::pair<std::string, std::string>>;  // name, content

/// Writes what `make` gives into the directory; that the first can be written is known before.
int run_chart(const std::string& directory, const std::string& first,
              const std::function<Files()>& make) {
  std::error_code failed;
  std::filesystem::create_directories(directory, failed);
  const std::filesystem::path base(directory);
  if (const int error = check_output((base / first).string())) return error;
  for (const auto& [name, content] : make())
    if (const int error = write_output((base / name).string(), content)) return error;
  return exit_code::kOk;
}

int run_ablation(const std::string& directory, const AblationStudyOptions& options) {
  return run_chart(directory, "ablation.csv", [&] {
    const ProgressBar bar;
    const std::vector<AblationOutcome> outcomes =
        study_ablations(options, [&](int done, int planned) { bar.show(done, planned, "cases"); });
    return Files{{"ablation.csv", ablation_csv(outcomes)},
                 {"ablation.svg", ablation_svg(outcomes)}};
  });
}

int run_speed_accuracy(const std::string& directory) {
  return run_chart(directory, "speed-accuracy.csv", [] {
    const ProgressBar bar;
    const std::vector<AccuracyPoint> points =
        study_accuracy({}, [&](int done, int planned) { bar.show(done, planned, "cases"); });
    return Files{{"speed-accuracy.csv", accuracy_csv(points)},
                 {"speed-accuracy.svg", accuracy_svg(points)},
                 {"speed-accuracy-orifice.svg", orifice_error_svg(points)}};
  });
}

// Finer ones take half a minute each.
constexpr int kNewtonTriangles = 2600, kXpbdTriangles = 2600;

ClosureRun close_by_newton(const ClosureModel& model, const AttemptSettings& attempt) {
  comparators::NewtonSettings settings;
  settings.residual_tolerance = kStabilityResidual;
  settings.pseudo_time = attempt.step;
  settings.contact = attempt.contact;
  return comparators::run_newton(model, settings);
}

ClosureRun close_by_xpbd(const ClosureModel& model, const AttemptSettings& attempt) {
  comparators::XpbdSettings settings;
  settings.residual_tolerance = kStabilityResidual;
  settings.substep = attempt.step;
  settings.contact = attempt.contact;
  return comparators::run_xpbd(model, settings);
}

int run_stability(const std::string& directory, const StabilityStudyOptions& options) {
  return run_chart(directory, "stability.csv", [&] {
    const ProgressBar bar;
    const std::vector<StabilityCell> cells = study_stability(
        options,
        {{"newton", close_by_newton, kNewtonTriangles}, {"xpbd", close_by_xpbd, kXpbdTriangles}},
        [&](int done, int planned) { bar.show(done, planned, "levels"); });
    return Files{{"stability.csv", stability_csv(cells)}, {"stability.svg", stability_svg(cells)}};
  });
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
                          "Draw speed, accuracy and stability of closures, and what they need")
          ->require_subcommand(1);
  const auto directory = std::make_shared<std::string>("charts");
  const auto add_output = [&](CLI::App& command) {
    command.add_option("-o,--output", *directory, "Directory for the CSV and the charts")
        ->capture_default_str();
  };
  CLI::App* accuracy = chart->add_subcommand(
      "speed-accuracy", "Close two presets by each method, membrane, resolution and tolerance");
  add_output(*accuracy);
  accuracy->footer(
      "Errors are against one reference a scene: membrane continuum, 5,200 triangles, residual "
      "1e-6.\n"
      "Takes a few minutes on one core; times are of this machine.\n\n"
      "Example:\n"
      "  coapt chart speed-accuracy -o charts");
  accuracy->callback([directory, &status] { status = run_speed_accuracy(*directory); });

  const auto options = std::make_shared<StabilityStudyOptions>();
  CLI::App* stability = chart->add_subcommand(
      "stability", "Map where each method of closing holds and where it fails");
  add_output(*stability);
  stability->add_option("--scene", options->scenes, "Only these")
      ->check(CLI::IsMember(options->scenes))
      ->capture_default_str();
  const auto axes = std::make_shared<std::vector<std::string>>();
  for (const DifficultyAxis& axis : options->axes) axes->push_back(to_string(axis.of));
  stability->add_option("--axis", *axes, "Only these")
      ->check(CLI::IsMember(*axes))
      ->capture_default_str();
  stability->add_option("--threads", options->threads, "0: all cores; does not change the map")
      ->check(number_from(0, 1024))
      ->capture_default_str();
  stability->footer(
      "Methods thesis, unguarded, fast, newton and xpbd make one attempt each; coapt is "
      "close_valve with its\n"
      "ladder, with default options. Scene commissures: human-normal, its annulus 20 % narrower.\n"
      "Takes several minutes on one core.\n\n"
      "Examples:\n"
      "  coapt chart stability -o charts\n"
      "  coapt chart stability --scene human-normal --axis pressure slivers -o charts");
  stability->callback([directory, options, axes, &status] {
    std::erase_if(options->axes, [&](const DifficultyAxis& axis) {
      return std::find(axes->begin(), axes->end(), to_string(axis.of)) == axes->end();
    });
    status = run_stability(*directory, *options);
  });

  add_ablation(*chart, status);
}

}  // namespace coapt
