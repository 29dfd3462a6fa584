#include <algorithm>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "clients/cli/closure_options.h"
#include "clients/cli/exit_code.h"
#include "clients/cli/files.h"
#include "clients/cli/progress_bar.h"
#include "io/command_line/command_line.h"
#include "lab/charts/tables.h"
#include "lab/cli/commands.h"
#include "lab/cli/draw.h"
#include "lab/closures/mesh_study.h"
#include "lab/comparators/newton.h"
#include "lab/comparators/xpbd.h"

namespace coapt {
namespace {

/// Writes the table that `make` gives into the directory, and draws it; that it can be written is known before.
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

int run_mesh(const std::string& directory, const MeshStudyOptions& options) {
  return run_chart(directory, "mesh.csv", [&] {
    const ProgressBar bar;
    return mesh_csv(
        study_meshes(options, [&](int done, int planned) { bar.show(done, planned, "scenes"); }));
  });
}

int run_gap(const std::string& directory) {
  return run_chart(directory, "gap.csv", [] {
    const ProgressBar bar;
    return gap_csv(
        study_gap({}, [&](int done, int planned) { bar.show(done, planned, "meshes"); }));
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
    return stability_csv(study_stability(
        options,
        {{"newton", close_by_newton, kNewtonTriangles}, {"xpbd", close_by_xpbd, kXpbdTriangles}},
        [&](int done, int planned) { bar.show(done, planned, "levels"); }));
  });
}

/// Of a command's chart; its table goes there, too.
std::shared_ptr<std::string> add_output(Command command) {
  const auto directory = std::make_shared<std::string>("charts");
  command.add_option("-o,--output", *directory, "Directory for the CSV file and its charts")
      .show_default();
  return directory;
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
      "Shows what each ingredient contributes (change of orifice and shape against the full "
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

void add_gap(Command chart, int& status) {
  Command command =
      chart.add_command("gap", "Measure the gap of surfaces and closures on growing meshes");
  const auto directory = add_output(command);
  command.footer(
      "Of two surfaces the gap is known exactly; of closures the finest mesh is the reference. "
      "The\n"
      "gap of nine sections is drawn beside it. Takes half a minute on one core.\n\n"
      "Example:\n"
      "  coapt-lab chart gap -o charts");
  command.on_run([directory, &status] { status = run_gap(*directory); });
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
  command.add_option("--threads", options->threads, "0: all cores; does not change the map")
      .check(number_from(0, 1024))
      .show_default();
  command.footer(
      "Methods thesis, unguarded, fast, newton and xpbd make one attempt each; coapt is the\n"
      "closure of coapt itself, with default options, which tries again where an attempt fails.\n"
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

void add_mesh(Command chart, int& status) {
  const auto options = std::make_shared<MeshStudyOptions>();
  Command command = chart.add_command("mesh", "Close varied scenes on meshes of growing fineness");
  const auto directory = add_output(command);
  command.add_option("--scenes", options->scenes, "Varied scenes of each preset")
      .check(number_from(1, 10000))
      .show_default();
  command.add_option("--preset", options->presets, "Only these presets").show_default();
  command
      .add_option("--anatomies", options->anatomies,
                  "Random anatomies besides, one varied scene of each")
      .check(number_from(0, 10000))
      .show_default();
  command
      .add_option("--reference", options->reference_triangles,
                  "Triangles of the mesh that the others are compared with; half as many take a "
                  "sixth of the time")
      .check(number_from(100, 100000))
      .show_default();
  command.add_flag("--refined", options->refined,
                   "Refine a mesh of 650 triangles twice instead of making the valve anew");
  command.add_option("--seed", options->seed, "Same seed, same scenes").show_default();
  add_membrane_option(command, options->membrane);
  command.add_option("--threads", options->threads, "0: all cores; does not change the areas")
      .check(number_from(0, 1024))
      .show_default();
  command.footer(
      "Orifice, gap, leak and shape on 325 to 5,200 triangles (those below the reference), each\n"
      "against 10,400 of the same scene, which takes one core half a minute.\n\n"
      "Example:\n"
      "  coapt-lab chart mesh --scenes 12 -o charts");
  command.on_run([directory, options, &status] {
    if (options->refined) options->triangles = {650, 2600};
    std::erase_if(options->triangles,
                  [&](int triangles) { return triangles >= options->reference_triangles; });
    status = run_mesh(*directory, *options);
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
  add_mesh(chart, status);
  add_gap(chart, status);
}

}  // namespace coapt
