#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "io/command_line/command_line.h"
#include "io/command_line/progress_bar.h"
#include "lab/charts/tables.h"
#include "lab/cli/chart_parts.h"
#include "lab/cli/chart_twins.h"
#include "lab/cli/commands.h"
#include "lab/comparators/newton.h"
#include "lab/comparators/xpbd.h"

namespace coapt {
namespace {

int run_ablation(const std::string& directory, const AblationStudyOptions& options) {
  return run_chart(directory, "ablation.csv", [&] {
    const ProgressBar bar;
    return ablation_csv(
        study_ablations(options, [&](int done, int planned) { bar.show(done, planned, "cases"); }));
  });
}

int run_speed_accuracy(const std::string& directory) {
  return run_chart(directory, "speed-accuracy.csv", [] {
    const ProgressBar bar;
    return accuracy_csv(
        study_accuracy({}, [&](int done, int planned) { bar.show(done, planned, "cases"); }));
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
    return stability_csv(
        study_stability(options,
                        {{"newton", close_by_newton, kNewtonTriangles, Membrane::Springs},
                         {"xpbd", close_by_xpbd, kXpbdTriangles, Membrane::Springs}},
                        [&](int done, int planned) { bar.show(done, planned, "levels"); }));
  });
}

void add_ablation(Command chart, int& status) {
  const auto options = std::make_shared<AblationStudyOptions>();
  Command command = chart.add_command(
      "ablation", "Close four presets with each ingredient of the model removed or replaced");
  const auto directory = add_output(command);
  command
      .add_option("--variations", options->variations,
                  "Dilated and displaced variations of each preset, besides the preset itself")
      .check(number_from(0, 1000))
      .show_default();
  command.add_option("--repeats", options->repeats, "Timed closures of each; the median counts")
      .check(number_from(1, 100))
      .show_default();
  command.footer(
      "Shows what each ingredient contributes (change of leak and shape against the full "
      "model)\n"
      "and what it costs (time of a whole closure, measured alternately with the full model's).\n"
      "Takes a few minutes on one core.\n\n"
      "Example:\n"
      "  coapt-lab chart ablation -o charts");
  command.on_run([directory, options, &status] { status = run_ablation(*directory, *options); });
}

void add_speed_accuracy(Command chart, int& status) {
  Command command = chart.add_command(
      "speed-accuracy", "Close two presets with each method, membrane, resolution and tolerance");
  const auto directory = add_output(command);
  command.footer(
      "Errors are distances from one reference per scene: membrane continuum, 5,200 triangles,\n"
      "residual 1e-6. Takes a few minutes on one core; times are those of this machine.\n\n"
      "Example:\n"
      "  coapt-lab chart speed-accuracy -o charts");
  command.on_run([directory, &status] { status = run_speed_accuracy(*directory); });
}

void add_stability(Command chart, int& status) {
  const auto options = std::make_shared<StabilityStudyOptions>();
  Command command =
      chart.add_command("stability", "Map where each closing method works and where it fails");
  const auto directory = add_output(command);
  command.add_option("--scene", options->scenes, "Only these scenes")
      .one_of(options->scenes)
      .show_default();
  const auto axes = std::make_shared<std::vector<std::string>>();
  for (const DifficultyAxis& axis : options->axes) axes->push_back(to_string(axis.of));
  command.add_option("--axis", *axes, "Only these axes of difficulty").one_of(*axes).show_default();
  add_threads_option(command, options->threads, "map");
  command.footer(
      "Each method makes one attempt, but for coapt: the closure of coapt itself, with default\n"
      "options, which tries again where an attempt fails. Methods thesis, newton, xpbd and\n"
      "fast (springs) close membrane springs, the others membrane continuum.\n"
      "Scene commissures is human-normal with its annulus 30 % narrower. Takes several minutes on\n"
      "one core.\n\n"
      "Examples:\n"
      "  coapt-lab chart stability -o charts\n"
      "  coapt-lab chart stability --scene human-normal --axis pressure slivers -o charts");
  command.on_run([directory, options, axes, &status] {
    std::erase_if(options->axes, [&](const DifficultyAxis& axis) {
      return std::find(axes->begin(), axes->end(), to_string(axis.of)) == axes->end();
    });
    status = run_stability(*directory, *options);
  });
}

}  // namespace

void add_chart(Command parent, int& status) {
  Command chart =
      parent.add_command("chart", "Chart the speed, accuracy and stability of closures");
  chart.require_command();
  add_speed_accuracy(chart, status);
  add_stability(chart, status);
  add_ablation(chart, status);
  add_accuracy_charts(chart, status);
  add_twins(chart, status);
  add_ruptures(chart, status);
}

}  // namespace coapt
