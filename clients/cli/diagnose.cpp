#include <iostream>
#include <memory>
#include <optional>
#include <string>

#include "clients/cli/ask.h"
#include "clients/cli/commands.h"
#include "clients/cli/plan_option.h"
#include "clients/cli/read_argument.h"
#include "clients/cli/server_option.h"
#include "core/valve/number_text.h"
#include "io/command_line/exit_code.h"
#include "io/command_line/files.h"
#include "io/picture/text_table.h"

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
  TableRows rows = {{"segment", "finding", "edge above annulus", "override", "length of edge",
                     "ruptured chordae"}};
  const auto mm = [](const Json& value) { return with_decimals(value.get<double>(), 1) + " mm"; };
  for (const Json& segment : diagnosis["segments"])
    rows.push_back({segment["name"],
                    segment["finding"].get<std::string>() +
                        (segment["sure"].get<bool>() ? "" : " (uncertain)"),
                    mm(segment["edge_mm"]), mm(segment["override_mm"]), mm(segment["width_mm"]),
                    std::to_string(segment["ruptured_chordae"].get<int>())});
  print_table(out, rows);
  const Json &tips = diagnosis["tip_to_trigone_mm"], &annulus = diagnosis["annulus"];
  out << "\nDistance from papillary tip to trigone: " << mm(tips["anterolateral"]) << " and "
      << mm(tips["posteromedial"]) << "; tenting " << mm(diagnosis["tenting_height_mm"])
      << "; annulus " << mm(annulus["ap_mm"]) << " x " << mm(annulus["transverse_mm"])
      << (annulus["dilated"].get<bool>() ? ", dilated" : "")
      << ".\nUse --json for the thresholds and their sources.\n";
}

int run(const DiagnoseArguments& arguments, const std::optional<Service>& service) {
  AskedRequest asked = asked_repair(arguments.valve, arguments.plan, service);
  if (asked.failed) return asked.failed;
  const Expected<Json> diagnosis = ask_document(service, "diagnose", asked.request, asked.here);
  if (!diagnosis) {
    const int status = report_refusal("diagnose", diagnosis.errors(), asked.sources);
    const Error& first = diagnosis.errors().front();
    const bool closes = first.code != ErrorCode::BadGeometry || !first.path.empty();
    return closes ? status : exit_code::kNotClosed;
  }
  if (arguments.json)
    std::cout << json_text(*diagnosis, 2) << '\n';
  else
    print_diagnosis(std::cout, *diagnosis);
  return exit_code::kOk;
}

}  // namespace

void add_diagnose(Command parent, int& status) {
  const auto arguments = std::make_shared<DiagnoseArguments>();
  Command command = parent.add_command(
      "diagnose", "Find why a valve leaks: Carpentier type and finding for each segment");
  command.add_option("valve", arguments->valve, kValveHelp).required();
  add_plan_option(command, arguments->plan);
  command.add_flag("--json", arguments->json,
                   "Print JSON (coapt.diagnosis/1), including the thresholds");
  add_server_option(command, arguments->server);
  command.footer(
      "A segment prolapses if its free edge overrides the opposite one by 4 mm more than in "
      "competent\nvalves, or lies above the annulus; it is flail if its chordae are ruptured and "
      "it\noverrides by 2 mm more, or leaks through an opening of its own. A finding close\nto a "
      "threshold is marked as uncertain, with its alternative. The "
      "exit code is 3 if the closure did\nnot converge.\n\n"
      "Examples:\n"
      "  coapt diagnose human-p2-prolapse\n"
      "  coapt diagnose valve.json --json\n"
      "  coapt diagnose valve.json --plan examples/plans/ring.json    # what a repair leaves");
  on_run_by(command, "diagnose", arguments->server, {}, status,
            [arguments](const auto& service) { return run(*arguments, service); });
}

}  // namespace coapt
