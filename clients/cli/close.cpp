#include <chrono>
#include <iostream>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "clients/cli/commands.h"
#include "clients/cli/converge_option.h"
#include "clients/cli/material_option.h"
#include "clients/cli/method_option.h"
#include "clients/cli/plan_option.h"
#include "clients/cli/print.h"
#include "clients/cli/read_argument.h"
#include "clients/cli/result_exit_code.h"
#include "clients/cli/server_option.h"
#include "core/closed/accurate_closure.h"
#include "core/closure/standing.h"
#include "core/repair/apply_plan.h"
#include "io/command_line/exit_code.h"
#include "io/command_line/files.h"
#include "io/command_line/progress_bar.h"
#include "io/exchange/import_files.h"
#include "io/json/model_study_json.h"
#include "io/json/opening_json.h"
#include "io/json/result_json.h"
#include "io/mesh/write_mesh.h"
#include "io/picture/opening_picture.h"
#include "io/picture/picture.h"
#include "search/plans/gates.h"
#include "search/studies/model_study.h"

namespace coapt {
namespace {

struct CloseArguments {
  std::string valve, picture, closed;
  PlanOption plan;
  MaterialOption material;
  ServerOption server;
  ClosureOptions closure;
  std::optional<double> accuracy_mm2;
  ConvergeOption converge;
  int draws = 0;
  bool json = false, open = false;
};

constexpr int kMostDraws = 1000;

/// Adds the tissue's part of the leak's error, by as many draws as asked for.
void add_tissue(const CloseArguments& arguments, const Valve& valve, const RepairPlan& plan,
                const Valve& repaired, Json& json) {
  ModelStudyOptions study;
  study.draws = arguments.draws;
  study.evaluate = closing_evaluator(arguments.closure, LeakBy::Surface);
  if (!plan.steps.empty()) study.unrepaired = &valve;
  const ProgressBar bar;
  study.progress = [&](int done, int planned) { bar.show(done, planned, "draws"); };
  const ModelStudy drawn = study_model(repaired, study);
  const std::optional<Interval> tissue = tissue_interval(drawn);
  json["leak"]["tissue"] = tissue ? Json{tissue->low, tissue->high} : Json();
  json["tissue_draws"] = tissue_draws_json(drawn);
}

/// Prints coapt.closure/2; returns an exit code.
int show(const CloseArguments& arguments, const Json& closure) {
  if (arguments.json) {
    std::cout << closure.dump(2) << '\n';
  } else {
    print_closure(std::cout, closure);
  }
  return exit_code_of_closure(closure);
}

int run_by(const Service& service, const CloseArguments& arguments) {
  auto [unsent, request, sources] = repair_to_send(arguments.valve, arguments.plan);
  if (unsent) return unsent;
  if (is_given(arguments.material)) request["material"] = material_json(arguments.material);
  if (const int failed = check_output(arguments.picture)) return failed;
  const Expected<Json> closure = post_json(service, "/v1/closures", request);
  if (!closure) return report_service_errors("close", closure.errors(), sources);
  const int status = show(arguments, *closure);
  if (arguments.picture.empty()) return status;
  const Expected<std::string> picture = post(service, "/v1/pictures", request);
  if (!picture) return report_service_errors("close", picture.errors(), sources);
  const int failed = write_output(arguments.picture, *picture);
  return failed != exit_code::kOk ? failed : status;
}

/// Writes the leaflets where --closed says, if it does; returns an exit code.
int write_closed(const CloseArguments& arguments, const Valve& valve,
                 const ClosureResult& closure) {
  if (arguments.closed.empty()) return exit_code::kOk;
  const Expected<std::string> mesh = write_mesh(leaflet_mesh(valve, closure.closed_mm),
                                                format_of(arguments.closed), doubt_about(closure));
  if (!mesh) return report_errors(arguments.closed, mesh.errors());
  note_doubt(arguments.closed, closure);
  return write_output(arguments.closed, *mesh);
}

/// A valve that is not mitral: closed and measured; no plans, no picture.
int run_leaflets(const CloseArguments& arguments, const Valve& valve, ClosureOptions options) {
  if (is_given(arguments.plan) || is_given(arguments.material) || !arguments.picture.empty() ||
      arguments.open || arguments.accuracy_mm2 || arguments.draws > 0)
    return report_errors(
        arguments.valve,
        {{ErrorCode::Unsupported, "/schema",
          "is coapt.valve/2: plans, pictures, pressure, tissue, --open, --draws and --accuracy "
          "need a mitral valve (coapt.valve/1)"}});
  if (const int failed = check_output(arguments.closed)) return failed;
  const auto start = std::chrono::steady_clock::now();
  const ClosureResult closure = close_valve(valve, options);
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  auto json = closure_to_json(valve, closure, measure(valve, closure), seconds.count());
  json["warnings"] = Json::array();
  const int status = show(arguments, json);
  const int failed = write_closed(arguments, valve, closure);
  return failed != exit_code::kOk ? failed : status;
}

int run(const CloseArguments& arguments) {
  ClosureOptions options = arguments.closure;
  if (options.method == Method::Thesis) options.samples = kThesisSamples;
  Expected<Valve> valve = read_any_valve_argument(arguments.valve);
  if (!valve) return report_errors(arguments.valve, valve.errors());
  if (!is_mitral(*valve)) return run_leaflets(arguments, *valve, arguments.closure);
  valve = with_material(*valve, values_of(arguments.material));
  if (!valve)
    return report_option_errors("close", valve.errors(), {{"/pressure_mmhg", "--pressure"}});
  const Expected<RepairPlan> plan = read_plan_option(arguments.plan, &*valve);
  if (!plan) return report_errors(source_of(arguments.plan), plan.errors());
  const Expected<Valve> repaired = apply_plan(*valve, *plan);
  if (!repaired) return report_errors(source_of(arguments.plan), repaired.errors());
  for (const std::string& output : {arguments.picture, arguments.closed})
    if (const int failed = check_output(output)) return failed;
  if (arguments.accuracy_mm2 && options.method != Method::Fast)
    return report_option_errors("close",
                                {{ErrorCode::Unsupported, "/accuracy",
                                  "is known for method fast only; leave out --method thesis"}});

  const auto start = std::chrono::steady_clock::now();
  std::optional<TimedConvergence> finer;
  std::optional<AccurateClosure> accurate;
  if (arguments.converge.wanted) finer = converge(*repaired, arguments.converge, options);
  if (arguments.accuracy_mm2) {
    Expected<AccurateClosure> within = close_within(*repaired, *arguments.accuracy_mm2, options);
    if (!within) return report_option_errors("close", within.errors());
    accurate = *std::move(within);
  }
  ClosedValve closed = finer      ? finer->convergence.finest
                       : accurate ? accurate->closed
                                  : close_and_measure(*repaired, options);
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  closed = with_repair(std::move(closed), *valve, *plan);
  const ClosureResult& closure = closed.closure;

  std::optional<OpenedValve> opened;
  const auto opening_start = std::chrono::steady_clock::now();
  if (arguments.open) {
    Expected<OpenedValve> open = open_valve(*repaired);
    if (!open) return report_errors(arguments.valve, open.errors());
    opened = *std::move(open);
  }
  const std::chrono::duration<double> opening_seconds =
      std::chrono::steady_clock::now() - opening_start;

  std::vector<std::string> warnings = warnings_of(operation_gates({*plan, *valve, *repaired}));
  if (opened)
    for (std::string& warning : opening_warnings(*opened)) warnings.push_back(std::move(warning));

  auto json = closure_to_json(closed.valve, closure, closed.measure, seconds.count());
  if (arguments.draws > 0) add_tissue(arguments, *valve, *plan, *repaired, json);
  if (finer) json["convergence"] = std::move(finer->json);
  if (opened) json["opening"] = opening_figures_json(*opened, opening_seconds.count());
  if (accurate) json["accuracy"] = to_json(*accurate, *arguments.accuracy_mm2);
  json["warnings"] = warnings;
  const int status = show(arguments, json);
  if (const int failed = write_closed(arguments, *repaired, closure)) return failed;
  if (!arguments.picture.empty()) {
    if (const int failed = write_output(
            arguments.picture, closure_picture_png(closed, opened ? opening_line(*opened) : "")))
      return failed;
  }
  return status;
}

}  // namespace

void add_close(Command parent, int& status) {
  const auto arguments = std::make_shared<CloseArguments>();
  Command command = parent.add_command("close", "Close a valve and measure what leaks");
  command.add_option("valve", arguments->valve, kValveHelp).required();
  add_plan_option(command, arguments->plan);
  add_method_option(command, arguments->closure.method);
  add_membrane_option(command, arguments->closure.membrane);
  add_converge_option(command, arguments->converge);
  add_material_option(command, arguments->material);
  command
      .add_option("--accuracy", arguments->accuracy_mm2,
                  "Largest error of the leak, mm2: refines the mesh and chooses the tolerances "
                  "(method fast)")
      .check(number_from(0.0, std::numeric_limits<double>::max()))
      .show_argument("MM2")
      .excludes("--converge");
  command.add_option("--render", arguments->picture, "Write a picture of the closed valve (PNG)")
      .check({refuse_standard_output, "FILE"});
  command
      .add_option("--closed", arguments->closed, "Write the closed leaflets (PLY, OBJ, STL or VTK)")
      .check({refuse_standard_output, "FILE"});
  command
      .add_option(
          "--draws", arguments->draws,
          "Also close it under so many draws of tissue and chordae, 64 for instance: where the "
          "leak "
          "lies by what the model does not know, weighed by what was observed (coapt observe)")
      .check(number_from(0, kMostDraws))
      .show_default();
  command.add_flag("--open", arguments->open,
                   "Also open the valve as in diastole: opening and mean gradient (coapt open)");
  command.add_flag("--json", arguments->json, "Print JSON");
  add_server_option(command, arguments->server);
  command.footer(
      "Exit code 3 if the closure did not converge or leaflets cross; the result is "
      "printed\nanyway. Areas are anatomic, from geometry: not an EROA.\n\n"
      "Examples:\n"
      "  coapt close human-functional-mr --render leaking.png\n"
      "  coapt close human-functional-mr --plan examples/plans/ring.json --open\n"
      "  coapt close human-normal --pressure 60 --radial-extension 0.08\n"
      "  coapt close valve.json --accuracy 1\n"
      "  coapt close human-functional-mr --converge\n"
      "  coapt close seen.json --draws 64\n"
      "  coapt close trivalve.json --closed closed.ply\n"
      "  coapt close valve.json --plan examples/plans/ring.json --json\n"
      "  coapt close valve.json --server http://127.0.0.1:8080");
  command.on_run([arguments, command, &status] {
    const auto service = service_of(
        command, arguments->server,
        {"--method", "--membrane", "--accuracy", "--open", "--converge", "--closed", "--draws"});
    if (!service) {
      status = report_errors("close", service.errors());
    } else {
      status = *service ? run_by(**service, *arguments) : run(*arguments);
    }
  });
}

}  // namespace coapt
