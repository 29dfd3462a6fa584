#include <chrono>
#include <iostream>
#include <memory>
#include <string>

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
#include "io/json/opening_json.h"
#include "io/mesh/write_mesh.h"
#include "io/picture/opening_picture.h"
#include "search/plans/gates.h"

namespace coapt {
namespace {

struct OpenArguments {
  std::string valve, opened, picture;
  PlanOption plan;
  ServerOption server;
  OpeningOptions options;
  bool json = false;
};

/// Prints coapt.opening/2; returns an exit code.
int show(const OpenArguments& arguments, const Json& opening) {
  if (arguments.json)
    std::cout << opening.dump(2) << '\n';
  else
    print_opening(std::cout, opening);
  return exit_code_of_closure(opening);
}

int run_by(const Service& service, const OpenArguments& arguments) {
  auto [unsent, request, sources] = repair_to_send(arguments.valve, arguments.plan);
  if (unsent) return unsent;
  const OpeningOptions& options = arguments.options;
  if (options.pressure_mmhg) request["pressure_mmhg"] = *options.pressure_mmhg;
  if (options.flow_ml_s) request["flow_ml_s"] = *options.flow_ml_s;
  request["exercise"] = options.exercise;
  Expected<Json> opening = post_json(service, "/v1/openings", request);
  if (!opening) return report_service_errors("open", opening.errors(), sources);
  opening->erase("scene");
  return show(arguments, *opening);
}

int run(const OpenArguments& arguments) {
  const PlannedValve planned = read_planned_valve(arguments.valve, arguments.plan);
  if (planned.failed) return planned.failed;
  for (const std::string& output : {arguments.opened, arguments.picture})
    if (const int failed = check_output(output)) return failed;
  const auto start = std::chrono::steady_clock::now();
  const Expected<OpenedValve> opened = open_valve(planned.repaired, arguments.options);
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  if (!opened)
    return report_option_errors(
        "open", opened.errors(),
        {{"/pressure_mmhg", "--pressure"}, {"/flow_ml_s", "--flow"}, {"/exercise", "--exercise"}});
  auto json = opening_to_json(*opened, seconds.count());
  json["warnings"] = warnings_of(operation_gates({planned.plan, planned.valve, planned.repaired}));
  for (const std::string& warning : opening_warnings(*opened)) json["warnings"].push_back(warning);
  const int status = show(arguments, json);
  if (!arguments.opened.empty()) {
    const Expected<std::string> mesh =
        write_mesh(leaflet_mesh(opened->valve, opened->closure.closed_mm),
                   format_of(arguments.opened), doubt_about(opened->closure));
    if (!mesh) return report_errors(arguments.opened, mesh.errors());
    if (const int failed = write_output(arguments.opened, *mesh)) return failed;
  }
  if (!arguments.picture.empty())
    if (const int failed = write_output(arguments.picture,
                                        opening_picture_png(*opened, planned.valve, planned.plan)))
      return failed;
  return status;
}

}  // namespace

void add_open(Command parent, int& status) {
  const auto arguments = std::make_shared<OpenArguments>();
  Command command = parent.add_command("open", "Open a valve in diastole and measure its opening");
  command.add_option("valve", arguments->valve, kValveHelp).required();
  add_plan_option(command, arguments->plan);
  OpeningOptions& options = arguments->options;
  command
      .add_option(
          "--pressure", options.pressure_mmhg,
          "Atrium over ventricle at the peak of filling, mmHg; by default what the flow needs")
      .check(number_from(kFillingPressures_mmhg.min, kFillingPressures_mmhg.max));
  command
      .add_option(
          "--flow", options.flow_ml_s,
          "Mean flow of filling at rest, ml/s; by default 155, less through a small annulus")
      .check(number_from(kFillingFlows_ml_s.min, kFillingFlows_ml_s.max));
  command.add_option("--exercise", options.exercise, "Flow at exercise over that at rest")
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
      "Annulus and papillary tips are where diastole has them: the valve file's \"systole\" says\n"
      "how far systole moves them. A ring holds the annulus. Exit code 3 if the leaflets did not\n"
      "come to rest.\n\n"
      "Examples:\n"
      "  coapt open human-normal --render open.png\n"
      "  coapt open human-functional-mr --plan examples/plans/ring.json --json");
  command.on_run([arguments, command, &status] {
    const auto service = service_of(command, arguments->server, {"--render", "--opened"});
    if (!service) {
      status = report_errors("open", service.errors());
    } else {
      status = *service ? run_by(**service, *arguments) : run(*arguments);
    }
  });
}

}  // namespace coapt
