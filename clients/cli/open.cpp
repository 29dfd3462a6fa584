#include <chrono>
#include <iostream>
#include <memory>
#include <string>

#include "clients/cli/closure_options.h"
#include "clients/cli/commands.h"
#include "clients/cli/exit_code.h"
#include "clients/cli/files.h"
#include "clients/cli/plan_option.h"
#include "core/valve/number_text.h"
#include "io/exchange/import_files.h"
#include "io/json/opening_json.h"
#include "io/mesh/write_mesh.h"

namespace coapt {
namespace {

struct OpenArguments {
  std::string valve, opened;
  PlanOption plan;
  OpeningOptions options;
  bool json = false;
};

/// In cm2, as openings are given.
std::string cm2(double mm2) { return with_decimals(0.01 * mm2, 1) + " cm2"; }

void print(const OpenedValve& opened, const OpeningOptions& options) {
  const OpeningMeasure& measure = opened.measure;
  const bool settled = trusted(opened.closure);
  std::cout << opened.valve.name << ": "
            << (settled                   ? "open, at rest"
                : opened.closure.crossing ? "leaflets cross, no opening is measured"
                                          : "did not come to rest, no opening is measured")
            << '\n';
  if (!settled) return;
  std::cout << "  opening         " << cm2(measure.opening_area_mm2) << ", the narrowest passage, "
            << (measure.passage_depth_mm > 0.0
                    ? with_decimals(measure.passage_depth_mm, 0) + " mm below the annulus"
                    : std::string("at the annulus"))
            << "; funnel tilted by " << with_decimals(measure.tilt_deg, 0) << " degrees\n"
            << "  seen            " << cm2(measure.projected_area_mm2)
            << " along the annulus's normal; annulus " << cm2(measure.annulus_area_mm2)
            << " in diastole\n"
            << "  mean gradient   " << with_decimals(measure.gradient_mmhg, 1) << " mmHg at "
            << significant(options.flow_ml_s, 3) << " ml/s, "
            << with_decimals(measure.gradient_exercise_mmhg, 1) << " mmHg at "
            << significant(options.exercise * options.flow_ml_s, 3)
            << " ml/s (Gorlin, of the smaller area)\n"
            << "coapt is research software, not a medical device; not for clinical decisions.\n";
}

int run(const OpenArguments& arguments) {
  const PlannedValve planned = read_planned_valve(arguments.valve, arguments.plan);
  if (planned.failed) return planned.failed;
  if (const int failed = check_output(arguments.opened)) return failed;
  const auto start = std::chrono::steady_clock::now();
  const Expected<OpenedValve> opened = open_valve(planned.repaired, arguments.options);
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  if (!opened)
    return report_option_errors(
        "open", opened.errors(),
        {{"/pressure_mmhg", "--pressure"}, {"/flow_ml_s", "--flow"}, {"/exercise", "--exercise"}});
  if (arguments.json)
    std::cout << opening_to_json(*opened, arguments.options, seconds.count()).dump(2) << '\n';
  else
    print(*opened, arguments.options);
  if (!arguments.opened.empty()) {
    const Expected<std::string> mesh = write_mesh(
        leaflet_mesh(opened->valve, opened->closure.closed_mm), format_of(arguments.opened));
    if (!mesh) return report_errors(arguments.opened, mesh.errors());
    if (const int failed = write_output(arguments.opened, *mesh)) return failed;
  }
  return trusted(opened->closure) ? exit_code::kOk : exit_code::kNotClosed;
}

}  // namespace

void add_open(Command parent, int& status) {
  const auto arguments = std::make_shared<OpenArguments>();
  Command command = parent.add_command("open", "Open a valve in diastole and measure its opening");
  command.add_option("valve", arguments->valve, kValveHelp).required();
  add_plan_option(command, arguments->plan);
  OpeningOptions& options = arguments->options;
  command
      .add_option("--pressure", options.pressure_mmhg,
                  "Atrium over ventricle, mmHg; below 3 slack leaflets take long to settle")
      .check(number_from(1.0, 30.0))
      .show_default();
  command.add_option("--flow", options.flow_ml_s, "Mean flow of filling at rest, ml/s")
      .check(number_from(10.0, 1000.0))
      .show_default();
  command.add_option("--exercise", options.exercise, "Flow at exercise over that at rest")
      .check(number_from(1.0, 5.0))
      .show_default();
  command
      .add_option("--opened", arguments->opened, "Write the open leaflets (PLY, OBJ, STL or VTK)")
      .check({refuse_standard_output, "FILE"});
  command.add_flag("--json", arguments->json, "Print JSON (coapt.opening/1)");
  command.footer(
      "Annulus and papillary tips are where diastole has them: the valve file's \"systole\" says\n"
      "how far systole moves them. A ring holds the annulus. Exit code 3 if the leaflets did not\n"
      "come to rest.\n\n"
      "Examples:\n"
      "  coapt open human-normal\n"
      "  coapt open human-functional-mr --plan examples/plans/ring.json --json");
  command.on_run([arguments, &status] { status = run(*arguments); });
}

}  // namespace coapt
