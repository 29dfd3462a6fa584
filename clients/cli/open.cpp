#include <iostream>
#include <memory>
#include <optional>
#include <string>

#include "clients/cli/ask.h"
#include "clients/cli/commands.h"
#include "clients/cli/method_option.h"
#include "clients/cli/plan_option.h"
#include "clients/cli/print_opening.h"
#include "clients/cli/read_argument.h"
#include "clients/cli/result_exit_code.h"
#include "clients/cli/server_option.h"
#include "core/closure/standing.h"
#include "io/command_line/files.h"
#include "io/exchange/import_files.h"
#include "io/json/plan_json.h"
#include "io/mesh/write_mesh.h"
#include "io/picture/opening_picture.h"

namespace coapt {
namespace {

struct OpenArguments {
  std::string valve, opened, picture;
  PlanOption plan;
  ServerOption server;
  OpeningOptions options;
  bool json = false;
};

/// The leaflets where --opened says; returns an exit code.
int write_opened(const OpenArguments& arguments, const OpenedValve& opened) {
  const Expected<std::string> mesh =
      write_mesh(leaflet_mesh(opened.valve, opened.closure.closed_mm), format_of(arguments.opened),
                 doubt_about(opened.closure));
  if (!mesh) return report_errors(arguments.opened, mesh.errors());
  note_doubt(arguments.opened, opened.closure);
  return write_output(arguments.opened, *mesh);
}

int run(const OpenArguments& arguments, const std::optional<Service>& service) {
  AskedRequest asked = asked_repair(arguments.valve, arguments.plan, service);
  if (asked.failed) return asked.failed;
  const OpeningOptions& options = arguments.options;
  if (options.pressure_mmhg) asked.request["pressure_mmhg"] = *options.pressure_mmhg;
  if (options.flow_ml_s) asked.request["flow_ml_s"] = *options.flow_ml_s;
  asked.request["exercise"] = options.exercise;
  for (const std::string& output : {arguments.opened, arguments.picture})
    if (const int failed = check_output(output)) return failed;
  std::optional<OpenedValve> opened;
  asked.here.opened = [&](const OpenedValve& made) { opened = made; };
  Expected<Json> opening = ask_document(service, "open", asked.request, asked.here);
  if (!opening)
    return report_refusal("open", opening.errors(), asked.sources,
                          {{"/pressure_mmhg", "--pressure"}, {"/flow_ml_s", "--flow"}});
  opening->erase("scene");
  if (arguments.json)
    std::cout << json_text(*opening, 2) << '\n';
  else
    print_opening(std::cout, *opening);
  if (!arguments.opened.empty())
    if (const int failed = write_opened(arguments, *opened)) return failed;
  if (!arguments.picture.empty()) {
    const Expected<RepairPlan> plan =
        asked.request.contains("plan") ? plan_from_json(asked.request["plan"]) : RepairPlan();
    if (const int failed = write_output(
            arguments.picture,
            opening_picture_png(*opened, *asked.here.valve_named(arguments.valve), *plan)))
      return failed;
  }
  return exit_code_of_closure(*opening);
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
                  "Peak atrioventricular pressure difference during filling, mmHg (default: the "
                  "pressure that drives the flow)")
      .check(number_from(kFillingPressures_mmhg.min, kFillingPressures_mmhg.max));
  command
      .add_option("--flow", options.flow_ml_s,
                  "Mean filling flow at rest, ml/s (default: 155, less for a small annulus)")
      .check(number_from(kFillingFlows_ml_s.min, kFillingFlows_ml_s.max));
  command.add_option("--exercise", options.exercise, "Ratio of exercise flow to resting flow")
      .check(number_from(kExercises.min, kExercises.max))
      .show_default();
  command.add_option("--render", arguments->picture, "Write a picture of the open valve (PNG)")
      .check({refuse_standard_output, "FILE"});
  command
      .add_option("--opened", arguments->opened, "Write the open leaflets (PLY, OBJ, STL or VTK)")
      .check({refuse_standard_output, "FILE"});
  command.add_flag("--json", arguments->json, "Print JSON (coapt.opening/2)");
  add_server_option(command, arguments->server);
  command.footer(
      "Annulus and papillary tips are placed in their diastolic positions, using the systolic "
      "motion in\n\"systole\" of the valve file; a ring fixes the annulus. The exit code is 3 if "
      "the leaflets did not\nreach equilibrium.\n\n"
      "Examples:\n"
      "  coapt open human-normal --render open.png\n"
      "  coapt open human-functional-mr --plan examples/plans/ring.json --json");
  on_run_by(command, "open", arguments->server, {"--render", "--opened"}, status,
            [arguments](const auto& service) { return run(*arguments, service); });
}

}  // namespace coapt
