#include <cmath>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "clients/cli/method_option.h"
#include "io/command_line/command_line.h"
#include "io/command_line/progress_bar.h"
#include "lab/charts/tables.h"
#include "lab/cli/chart_parts.h"
#include "lab/closures/mesh_study.h"
#include "lab/closures/uniqueness_study.h"
#include "lab/verdicts/verdict_study.h"

namespace coapt {
namespace {

int run_mesh(const std::string& directory, const MeshStudyOptions& options) {
  return run_chart(directory, "mesh.csv", [&] {
    const ProgressBar bar;
    return mesh_csv(
        study_meshes(options, [&](int done, int planned) { bar.show(done, planned, "scenes"); }));
  });
}

int run_uniqueness(const std::string& directory, const UniquenessStudyOptions& options) {
  return run_chart(directory, "uniqueness.csv", [&] {
    const ProgressBar bar;
    return uniqueness_csv(study_uniqueness(
        options, [&](int done, int planned) { bar.show(done, planned, "scenes"); }));
  });
}

void print(std::ostream& out, const std::vector<JudgedPlan>& plans) {
  for (const auto& [mesh, valves, count] : verdict_agreements(plans))
    out << mesh << " mesh, " << valves << " valves: " << count.agree << " of " << count.plans
        << " verdicts agree, " << count.false_competent << " false \"competent\", "
        << count.false_leaks << " false \"leaks\"\n";
  for (const OrderAgreement& order : order_agreements(plans)) {
    out << order.order << " against the reference mesh's " << order.reference << ", "
        << order.valves << " valves: tau " << order.tau;
    if (std::isfinite(order.tau_apart))
      out << " (0.1 mm2 or more apart: " << order.tau_apart << ")";
    out << ", Spearman " << order.spearman << '\n';
  }
}

int run_verdicts(const std::string& directory, const VerdictStudyOptions& options) {
  std::vector<JudgedPlan> plans;
  const int status = run_chart(directory, "verdicts.csv", [&] {
    const ProgressBar bar;
    plans =
        study_verdicts(options, [&](int done, int planned) { bar.show(done, planned, "meshes"); });
    return verdicts_csv(plans);
  });
  print(std::cout, plans);
  return status;
}

/// --preset and --anatomies.
void add_valves(Command command, std::vector<std::string>& presets, int& anatomies) {
  command.add_option("--preset", presets, "Use only these presets").show_default();
  command.add_option("--anatomies", anatomies, "Random anatomies besides, one varied scene of each")
      .check(number_from(0, 10000))
      .show_default();
}

void add_mesh(Command chart, int& status) {
  const auto options = std::make_shared<MeshStudyOptions>();
  Command command = chart.add_command("mesh", "Close varied scenes on meshes of growing fineness");
  const auto directory = add_output(command);
  command.add_option("--scenes", options->scenes, "Varied scenes of each preset")
      .check(number_from(1, 10000))
      .show_default();
  add_valves(command, options->presets, options->anatomies);
  command
      .add_option("--reference", options->reference_triangles,
                  "Triangles of the mesh that the others are compared with; half as many take a "
                  "sixth of the time")
      .check(number_from(100, 100000))
      .show_default();
  command.add_flag("--refined", options->refined,
                   "Refine a mesh of 650 triangles twice instead of making the valve anew");
  command.add_option("--seed", options->seed, "Random seed; the same seed gives the same scenes")
      .show_default();
  add_membrane_option(command, options->membrane);
  add_threads_option(command, options->threads, "areas");
  command.footer(
      "Leak and shape on 325 to 5,200 triangles (those below the reference), each\n"
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

void add_uniqueness(Command chart, int& status) {
  const auto options = std::make_shared<UniquenessStudyOptions>();
  Command command = chart.add_command(
      "uniqueness", "Close varied scenes at full and at half the speed, at growing rigidities");
  const auto directory = add_output(command);
  command
      .add_option("--scenes", options->scenes,
                  "Varied scenes of each preset at the seed, and as many at the next")
      .check(number_from(1, 10000))
      .show_default();
  add_valves(command, options->presets, options->anatomies);
  command.add_option("--bending", options->bending_n_mm, "Flexural rigidities, N mm")
      .check(number_from(0.0, 10.0))
      .show_default();
  command.add_option("--seed", options->seed, "Random seed; the same seed gives the same scenes")
      .show_default();
  add_membrane_option(command, options->membrane);
  add_threads_option(command, options->threads, "ends");
  command.footer(
      "Each scene is closed with default tolerances, then to residual 1e-6 at full and at half "
      "the\n"
      "speed: two ends more than 0.05 mm rms apart are different equilibria. Takes some ten "
      "minutes.\n\n"
      "Example:\n"
      "  coapt-lab chart uniqueness --scenes 10 --anatomies 20 -o charts");
  command.on_run([directory, options, &status] { status = run_uniqueness(*directory, *options); });
}

void add_verdicts(Command chart, int& status) {
  const auto options = std::make_shared<VerdictStudyOptions>();
  Command command = chart.add_command(
      "verdicts", "Judge random plans on the search's mesh, the refined one and a finer one");
  const auto directory = add_output(command);
  command.add_option("--plans", options->plans, "Random plans for each of six valves")
      .check(number_from(2, 50))
      .show_default();
  command.add_option("--seed", options->seed, "Random seed; the same seed gives the same plans")
      .show_default();
  command
      .add_option("--nodes", options->nodes,
                  "Of the region of interest, for the order of plans on both meshes")
      .check(number_from(1, 1089))
      .show_default();
  command.add_option("--reference", options->reference_triangles, "Triangles of the finer mesh")
      .check(number_from(100, 50000))
      .show_default();
  add_threads_option(command, options->threads, "verdicts");
  command.footer(
      "Prints how many verdicts (competent: less than 1 mm2) and how far the orders agree. Three "
      "of\n"
      "the six valves are held out. Takes five minutes of one core, with --nodes 17 an hour.\n\n"
      "Example:\n"
      "  coapt-lab chart verdicts --plans 10 -o charts");
  command.on_run([directory, options, &status] { status = run_verdicts(*directory, *options); });
}

}  // namespace

void add_accuracy_charts(Command chart, int& status) {
  add_mesh(chart, status);
  add_uniqueness(chart, status);
  add_verdicts(chart, status);
}

}  // namespace coapt
