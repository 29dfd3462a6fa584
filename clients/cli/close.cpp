#include <iostream>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "clients/cli/ask.h"
#include "clients/cli/closing_option.h"
#include "clients/cli/commands.h"
#include "clients/cli/material_option.h"
#include "clients/cli/plan_option.h"
#include "clients/cli/print.h"
#include "clients/cli/read_argument.h"
#include "clients/cli/result_exit_code.h"
#include "clients/cli/server_option.h"
#include "core/closure/standing.h"
#include "io/command_line/files.h"
#include "io/command_line/progress_bar.h"
#include "io/exchange/import_files.h"
#include "io/mesh/write_mesh.h"
#include "io/picture/opening_picture.h"
#include "io/picture/picture.h"

namespace coapt {
namespace {

struct CloseArguments {
  std::string valve, picture, closed;
  PlanOption plan;
  MaterialOption material;
  ServerOption server;
  ClosingOption closing;
  int draws = 0;
  bool json = false, open = false;
};

constexpr int kMostDraws = 1000;

/// What the arguments ask for, beside valve and plan.
void add_options(const CloseArguments& arguments, Json& request) {
  if (is_given(arguments.material)) request["material"] = material_json(arguments.material);
  add_closing(arguments.closing, request);
  if (arguments.open) request["open"] = true;
  if (arguments.draws > 0) request["draws"] = arguments.draws;
}

/// What is wrong with the request in the words of the command line.
int report_close(const Errors& errors, const std::map<std::string, std::string>& sources) {
  constexpr std::string_view kMaterial = "/material";
  Errors told = errors;
  for (Error& error : told)
    if (error.path.starts_with(kMaterial)) error.path.erase(0, kMaterial.size());
  return report_refusal("close", told, sources,
                        {{"/accuracy_mm2", "--accuracy"}, {"/pressure_mmhg", "--pressure"}});
}

/// The leaflets where --closed says; returns an exit code.
int write_closed(const CloseArguments& arguments, const ClosedValve& closed) {
  const Expected<std::string> mesh =
      write_mesh(leaflet_mesh(closed.valve, closed.closure.closed_mm), format_of(arguments.closed),
                 doubt_about(closed.closure));
  if (!mesh) return report_errors(arguments.closed, mesh.errors());
  note_doubt(arguments.closed, closed.closure);
  return write_output(arguments.closed, *mesh);
}

/// What was closed here, for what else is made of it.
struct ClosedHere {
  std::optional<ClosedValve> closed;
  std::string diastole;  ///< a line for the picture
};

Expected<std::string> picture_of(AskedRequest& asked, const std::optional<Service>& service,
                                 const ClosedHere& made) {
  if (!service) return closure_picture_png(*made.closed, made.diastole);
  Json request = Json::object();
  for (const char* name : {"valve", "plan", "material", "open"})
    if (asked.request.contains(name)) request[name] = asked.request[name];
  const Expected<OperationAnswer> picture = ask(service, "picture", request, asked.here);
  if (!picture) return picture.errors();
  return std::get<AnswerFile>(*picture).bytes;
}

int run(const CloseArguments& arguments, const std::optional<Service>& service) {
  AskedRequest asked = asked_repair(arguments.valve, arguments.plan, service);
  if (asked.failed) return asked.failed;
  add_options(arguments, asked.request);
  for (const std::string& output : {arguments.picture, arguments.closed})
    if (const int failed = check_output(output)) return failed;
  ClosedHere made;
  asked.here.closed = [&](const ClosedValve& closed) { made.closed = closed; };
  asked.here.opened = [&](const OpenedValve& opened) { made.diastole = opening_line(opened); };
  const auto close_it = [&] {
    const ProgressBar bar;
    asked.here.progress = [&](int done, int planned) { bar.show(done, planned, "draws"); };
    return ask_document(service, "close", asked.request, asked.here);
  };
  const Expected<Json> closure = close_it();
  if (!closure) return report_close(closure.errors(), asked.sources);
  if (arguments.json)
    std::cout << json_text(*closure, 2) << '\n';
  else
    print_closure(std::cout, *closure);
  if (!arguments.closed.empty())
    if (const int failed = write_closed(arguments, *made.closed)) return failed;
  if (!arguments.picture.empty()) {
    const Expected<std::string> picture = picture_of(asked, service, made);
    if (!picture) return report_refusal("close", picture.errors(), asked.sources);
    if (const int failed = write_output(arguments.picture, *picture)) return failed;
  }
  return exit_code_of_closure(*closure);
}

}  // namespace

void add_close(Command parent, int& status) {
  const auto arguments = std::make_shared<CloseArguments>();
  Command command = parent.add_command("close", "Close a valve and measure what leaks");
  command.add_option("valve", arguments->valve, kValveHelp).required();
  add_plan_option(command, arguments->plan);
  add_closing_option(command, arguments->closing);
  add_material_option(command, arguments->material);
  command.add_option("--render", arguments->picture, "Write a picture of the closed valve (PNG)")
      .check({refuse_standard_output, "FILE"});
  command
      .add_option("--closed", arguments->closed, "Write the closed leaflets (PLY, OBJ, STL or VTK)")
      .check({refuse_standard_output, "FILE"});
  command
      .add_option(
          "--draws", arguments->draws,
          "Also close this many variants of tissue and chordae (64, for instance) to find the "
          "tissue error of the leak; variants are weighted by what was observed (coapt observe)")
      .check(number_from(0, kMostDraws))
      .show_default();
  command.add_flag(
      "--open", arguments->open,
      "Also open the valve in diastole and measure its opening and mean gradient (coapt open)");
  command.add_flag("--json", arguments->json, "Print JSON");
  add_server_option(command, arguments->server);
  command.footer(
      "The exit code is 3 if the closure did not converge or leaflets cross; the result is "
      "still\nprinted. Areas are anatomic, measured on the closed surface; they are not EROAs.\n\n"
      "Examples:\n"
      "  coapt close human-functional-mr --render leaking.png\n"
      "  coapt close human-functional-mr --plan examples/plans/ring.json --open\n"
      "  coapt close human-normal --pressure 60 --radial-extension 0.08\n"
      "  coapt close valve.json --accuracy 1\n"
      "  coapt close human-functional-mr --certainty proof\n"
      "  coapt close seen.json --draws 64\n"
      "  coapt close trivalve.json --closed closed.ply\n"
      "  coapt close valve.json --plan examples/plans/ring.json --json\n"
      "  coapt close valve.json --server http://127.0.0.1:8080");
  on_run_by(command, "close", arguments->server, {"--closed"}, status,
            [arguments](const auto& service) { return run(*arguments, service); });
}

}  // namespace coapt
