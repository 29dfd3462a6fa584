#include <iostream>
#include <limits>
#include <memory>
#include <string>

#include "clients/cli/commands.h"
#include "clients/cli/plan_option.h"
#include "clients/cli/print.h"
#include "clients/cli/print_table.h"
#include "clients/cli/read_argument.h"
#include "clients/cli/server_option.h"
#include "core/closed/closed_valve.h"
#include "core/closure/standing.h"
#include "core/opened/opened_valve.h"
#include "core/valve/number_text.h"
#include "io/command_line/exit_code.h"
#include "io/command_line/files.h"
#include "io/json/diagnosis_json.h"

namespace coapt {
namespace {

struct DiagnoseArguments {
  std::string valve;
  PlanOption plan;
  ServerOption server;
  bool json = false;
};

/// Of coapt.diagnosis/1.
void print_diagnosis(std::ostream& out, const Json& diagnosis) {
  out << diagnosis["sentence"].get<std::string>() << "\n\n";
  TableRows rows = {{"segment", "finding", "edge over annulus", "too high by", "over", "ruptured"}};
  const auto mm = [](const Json& value) { return with_decimals(value.get<double>(), 1) + " mm"; };
  for (const Json& segment : diagnosis["segments"])
    rows.push_back(
        {segment["name"],
         segment["finding"].get<std::string>() + (segment["sure"].get<bool>() ? "" : " (not sure)"),
         mm(segment["edge_mm"]), mm(segment["override_mm"]), mm(segment["width_mm"]),
         std::to_string(segment["ruptured_chordae"].get<int>())});
  print_table(out, rows);
  const Json &tips = diagnosis["tip_to_trigone_mm"], &annulus = diagnosis["annulus"];
  out << "\nPapillary tips to their trigones: " << mm(tips["anterolateral"]) << " and "
      << mm(tips["posteromedial"]) << "; tenting " << mm(diagnosis["tenting_height_mm"])
      << "; annulus " << mm(annulus["ap_mm"]) << " x " << mm(annulus["transverse_mm"])
      << (annulus["dilated"].get<bool>() ? ", dilated" : "")
      << ".\nThresholds and their sources: --json\n";
}

int show(const DiagnoseArguments& arguments, const Json& diagnosis) {
  if (arguments.json)
    std::cout << diagnosis.dump(2) << '\n';
  else
    print_diagnosis(std::cout, diagnosis);
  return exit_code::kOk;
}

int run_by(const Service& service, const DiagnoseArguments& arguments) {
  auto [unsent, request, sources] = repair_to_send(arguments.valve, arguments.plan);
  if (unsent) return unsent;
  const Expected<Json> diagnosis = post_json(service, "/v1/diagnoses", request);
  if (!diagnosis) return report_service_errors("diagnose", diagnosis.errors(), sources);
  return show(arguments, *diagnosis);
}

/// NaN if it did not open.
double opening_area_mm2(const Valve& valve) {
  const Expected<OpenedValve> opened = open_valve(valve);
  return opened ? opened->measure.opening_area_mm2 : std::numeric_limits<double>::quiet_NaN();
}

int run(const DiagnoseArguments& arguments) {
  const PlannedValve planned = read_planned_valve(arguments.valve, arguments.plan);
  if (planned.failed) return planned.failed;
  const ClosedValve closed = close_and_measure(planned.repaired);
  const auto diagnosis =
      diagnose(closed.valve, closed.closure, closed.measure, opening_area_mm2(planned.repaired));
  if (!diagnosis) {
    std::cerr << "coapt diagnose: " << arguments.valve
              << ": the closed valve says nothing: " << doubt_about(closed.closure) << '\n';
    return exit_code::kNotClosed;
  }
  return show(arguments, diagnosis_document(*diagnosis, closed.valve));
}

}  // namespace

void add_diagnose(Command parent, int& status) {
  const auto arguments = std::make_shared<DiagnoseArguments>();
  Command command = parent.add_command(
      "diagnose", "Say why a valve leaks: Carpentier's type, segment by segment");
  command.add_option("valve", arguments->valve, kValveHelp).required();
  add_plan_option(command, arguments->plan);
  command.add_flag("--json", arguments->json, "Print JSON (coapt.diagnosis/1), with thresholds");
  add_server_option(command, arguments->server);
  command.footer(
      "A segment prolapses where its free edge rides over the opposite one by 4 mm more than in "
      "closed\nvalves, or stands above the annulus; it is flail where its chordae are ruptured, "
      "too. Near a threshold\nthe finding is not sure, and what else it may be is said. Exit code "
      "3 if the valve did not close.\n\n"
      "Examples:\n"
      "  coapt diagnose human-p2-prolapse\n"
      "  coapt diagnose valve.json --json\n"
      "  coapt diagnose valve.json --plan examples/plans/ring.json    # what a repair leaves");
  command.on_run([arguments, command, &status] {
    const auto service = service_of(command, arguments->server, {});
    if (!service)
      status = report_errors("diagnose", service.errors());
    else
      status = *service ? run_by(**service, *arguments) : run(*arguments);
  });
}

}  // namespace coapt
