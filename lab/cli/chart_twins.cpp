#include "lab/cli/chart_twins.h"

#include <iostream>
#include <memory>

#include "io/command_line/progress_bar.h"
#include "lab/cli/chart_parts.h"
#include "lab/twins/rupture_table.h"
#include "lab/twins/twin_table.h"

namespace coapt {

void add_twins(Command chart, int& status) {
  const auto options = std::make_shared<TwinStudyOptions>();
  const auto unknown_leak = std::make_shared<bool>(false);
  Command command = chart.add_command(
      "twins",
      "Fit valves whose chordae, tips and tissue are known to a view of their closed state");
  const auto directory = add_output(command);
  command.add_option("--twins", options->twins, "Random anatomies")
      .check(number_from(1, 1000))
      .show_default();
  command.add_option("--seed", options->seed, "Of anatomies, draws and noise").show_default();
  command.add_option("--noise", options->echo.noise_mm, "Standard deviation of a point, mm")
      .check(number_from(0.0, 5.0))
      .show_default();
  command
      .add_option("--refinements", options->refinements,
                  "Number of refinements of the mesh on which twins are closed")
      .check(number_from(0, 2))
      .show_default();
  command.add_flag("--leak-unknown", *unknown_leak, "Withhold the leak from the fit");
  add_threads_option(command, options->fit.threads, "twins");
  command.footer(
      "Each twin is drawn from the priors of the fit, closed on a finer mesh, and seen from "
      "the\n"
      "atrium with noise, holes and smoothing.\n\n"
      "Example:\n"
      "  coapt-lab chart twins --twins 40 -o charts");
  command.on_run([=, &status] {
    options->leak_known = !*unknown_leak;
    std::vector<Twin> twins;
    status = run_chart(*directory, "twins.csv", [&] {
      const ProgressBar bar;
      twins =
          study_twins(*options, [&](int done, int planned) { bar.show(done, planned, "twins"); });
      return twins_csv(twins);
    });
    print_twins(std::cout, twins);
  });
}

void add_ruptures(Command chart, int& status) {
  const auto options = std::make_shared<TwinStudyOptions>();
  options->twins = 20;
  options->fit.ruptures = true;
  Command command = chart.add_command(
      "ruptures", "Fit valves, of which half have ruptured chordae that the fit gets whole");
  const auto directory = add_output(command);
  command.add_option("--twins", options->twins, "Random anatomies")
      .check(number_from(1, 1000))
      .show_default();
  command.add_option("--seed", options->seed, "Of anatomies, lesions, draws and noise")
      .show_default();
  add_threads_option(command, options->fit.threads, "twins");
  command.footer(
      "Twins as those of coapt-lab chart twins; every second pair has the marginal chordae of a\n"
      "random scallop ruptured. Says how many coapt fit --ruptured finds.\n\n"
      "Example:\n"
      "  coapt-lab chart ruptures --twins 40 -o charts");
  command.on_run([=, &status] {
    std::vector<Twin> twins;
    status = run_chart(*directory, "ruptures.csv", [&] {
      const ProgressBar bar;
      twins =
          study_twins(*options, [&](int done, int planned) { bar.show(done, planned, "twins"); });
      return ruptures_csv(twins);
    });
    print_ruptures(std::cout, twins);
  });
}

}  // namespace coapt
