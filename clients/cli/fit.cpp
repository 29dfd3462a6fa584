#include "search/fit/fit.h"

#include <filesystem>
#include <iomanip>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "clients/cli/ask.h"
#include "clients/cli/commands.h"
#include "clients/cli/method_option.h"
#include "clients/cli/read_argument.h"
#include "clients/cli/run_options.h"
#include "io/command_line/exit_code.h"
#include "io/command_line/files.h"
#include "io/command_line/interrupt.h"
#include "io/command_line/progress_bar.h"
#include "io/exchange/import_files.h"
#include "io/json/base64.h"
#include "io/json/valve_json.h"
#include "io/picture/text.h"
#include "operations/surface_file.h"

namespace coapt {
namespace {

constexpr double kMostSeconds = 600.0;

struct FitArguments {
  std::string valve, closed, output, picture;
  std::string frame, side = "atrial";
  std::optional<double> leak_mm2;
  double leak_sd_mm2 = MeasuredClosure{}.leak_sd_mm2;
  std::vector<std::string> known;
  FitOptions options;
  ServerOption server;
  bool json = false;
};

/// What the arguments ask for, beside valve and surface.
void add_options(const FitArguments& arguments, Json& request) {
  const FitOptions& options = arguments.options;
  request.update(Json{{"source", arguments.valve},
                      {"side", arguments.side},
                      {"leak_sd_mm2", arguments.leak_sd_mm2},
                      {"known", arguments.known},
                      {"slack_sd", options.unknowns.slack_sd},
                      {"tip_sd_mm", options.unknowns.tip_sd_mm},
                      {"hidden_sd_mm", options.unknowns.hidden_sd_mm},
                      {"ruptured", options.ruptures},
                      {"points", options.most_points},
                      {"rounds", options.most_rounds},
                      {"seconds", options.most_seconds},
                      {"membrane", to_string(options.closure.membrane)},
                      {"map", !arguments.picture.empty()}});
  if (!arguments.frame.empty()) request["frame"] = arguments.frame;
  if (arguments.leak_mm2) request["leak_mm2"] = *arguments.leak_mm2;
}

std::string why(const Json& stop) {
  return stop == "round_limit" ? " (--rounds)" : stop == "time_limit" ? " (--seconds)" : "";
}

/// Those of --ruptured, if it was given.
void print_hypotheses(std::ostream& out, const Json& fit) {
  if (!fit.contains("hypotheses")) return;
  out << "\n  " << std::left << std::setw(14) << "hypothesis" << std::right << std::setw(13)
      << "probability" << std::setw(9) << "rms, mm" << std::setw(11) << "leak, mm2"
      << "\n";
  for (const Json& of : fit["hypotheses"]) {
    out << "  " << std::left << std::setw(14) << of["name"].get<std::string>() << std::right
        << std::setw(13) << fixed(of["probability"], 3);
    if (of["rms_mm"].is_null())
      out << "  closure failed";
    else
      out << std::setw(9) << fixed(of["rms_mm"], 3) << std::setw(11) << fixed(of["leak_mm2"], 1)
          << (of["taken"]      ? "  selected"
              : of["refitted"] ? ""
                               : "  not fitted");
    out << '\n';
  }
  const char* separator = "skipped at the time limit: ";
  for (const Json& name : fit["hypotheses_left_out"]) {
    out << separator << name.get<std::string>();
    separator = ", ";
  }
  if (!fit["hypotheses_left_out"].empty()) out << '\n';
}

void print_fit(std::ostream& out, const Json& fit) {
  const Json& leak = fit["leak_mm2"];
  out << "distance   " << fixed(fit["rms_before_mm"], 3) << " mm rms before, "
      << fixed(fit["rms_mm"], 3) << " mm after, of " << fit["points"]["used"]
      << " points, equivalent to " << fixed(fit["points"]["independent"], 0)
      << " independent points\n"
      << "leak       " << fixed(leak["before"], 1) << " mm2 before, " << fixed(leak["fitted"], 1)
      << " ± " << fixed(leak["sd"], 1) << " mm2 after";
  if (leak.contains("given"))
    out << " (given: " << fixed(leak["given"], 1) << " ± " << fixed(leak["given_sd"], 1) << ')';
  out << "\n\n  " << std::left << std::setw(28) << "parameter" << std::right << std::setw(9)
      << "value" << std::setw(9) << "sd" << std::setw(9) << "before" << std::setw(9) << "sd"
      << "\n";
  for (const Json& fitted : fit["parameters"]) {
    const bool mm = fitted["unit"] == "mm";
    out << "  " << std::left << std::setw(28)
        << (printable(fitted["name"].get<std::string>()) + (mm ? ", mm" : "")) << std::right;
    for (const char* number : {"value", "sd", "prior", "prior_sd"})
      out << std::setw(9) << fixed(fitted[number], mm ? 2 : 3);
    out << (fitted["identifiable"] ? "" : "  weakly constrained by the data") << '\n';
  }
  print_hypotheses(out, fit);
  if (!fit["finished"]) out << "\nstopped before convergence" << why(fit["stop"]) << '\n';
}

Expected<Json> surface_to_send(const std::string& path) {
  const std::string format = format_of(path);
  if (is_shape_format(format) || format == "csv") return file_to_send(path);
  return Error{ErrorCode::Unsupported, "",
               "must end in one of " + shape_format_names() + ", or in csv (x,y,z lines)"};
}

/// The answer, while a bar shows how far it is.
Expected<Json> ask_for_fit(const std::optional<Service>& service, AskedRequest& asked) {
  const ProgressBar bar;
  double rms_mm = 0.0;
  asked.here.surface_of = read_surface_file;
  asked.here.interrupted = &catch_interrupts();
  asked.here.distance = [&](double now_mm) { rms_mm = now_mm; };
  asked.here.progress = [&](int round, int rounds) {
    bar.show(round, rounds, "rounds (maximum), rms " + fixed(rms_mm, 3) + " mm");
  };
  return ask_document(service, "fit", asked.request, asked.here);
}

int run(const FitArguments& arguments, const std::optional<Service>& service) {
  for (const std::string& output : {arguments.output, arguments.picture})
    if (const int failed = check_output(output)) return failed;
  AskedRequest asked = asked_repair(arguments.valve, {}, service);
  if (asked.failed) return asked.failed;
  const Expected<Json> surface = surface_to_send(arguments.closed);
  if (!surface) return report_errors(arguments.closed, surface.errors());
  const std::string surface_name = std::filesystem::path(arguments.closed).filename().string();
  asked.request["surface"] = {{"file", *surface}, {"source", surface_name}};
  asked.sources["/surface/file"] = arguments.closed;
  add_options(arguments, asked.request);
  asked.here.limits.threads = arguments.options.threads;
  Expected<Json> fit = ask_for_fit(service, asked);
  if (!fit)
    return report_refusal(
        "fit", fit.errors(), asked.sources,
        {{"/surface", "--closed"}, {"/leak_mm2", "--leak"}, {"/known", "--known"}});
  const Expected<Valve> fitted = read_any_valve((*fit)["fitted"].dump());
  if (!fitted) return report_errors("fit", fitted.errors());
  if (const int failed = write_output(arguments.output, write_valve(*fitted))) return failed;
  if (!arguments.picture.empty() && fit->contains("map"))
    if (const int failed =
            write_output(arguments.picture,
                         decoded_base64((*fit)["map"]["base64"].get<std::string>()).value_or("")))
      return failed;
  fit->erase("fitted");
  fit->erase("map");
  (*fit)["closed"] = arguments.closed;  // with its folder, which the valve's provenance leaves out
  if (arguments.json)
    std::cout << json_text(*fit, 2) << '\n';
  else
    print_fit(std::cout, *fit);
  for (const Json& doubt : (*fit)["doubts"])
    std::cerr << "coapt: fit: check this against the images: " << doubt.get<std::string>() << ".\n";
  return (*fit)["finished"] && (*fit)["doubts"].empty() ? exit_code::kOk : exit_code::kNotClosed;
}

}  // namespace

void add_fit(Command parent, int& status) {
  const auto arguments = std::make_shared<FitArguments>();
  FitOptions& options = arguments->options;
  FitUnknowns& unknowns = options.unknowns;
  Command command = parent.add_command(
      "fit", "Fit chordae, papillary tips and tissue of a valve to its imaged closed state");
  command.add_option("valve", arguments->valve, kValveHelp).required();
  command
      .add_option("--closed", arguments->closed,
                  "Imaged closed leaflets: a mesh (OBJ, PLY, STL, VTK, VTP, VTU) or points (CSV), "
                  "in millimetres")
      .required();
  command.add_option("-o,--output", arguments->output, "File for the fitted valve")
      .required()
      .check({refuse_standard_output, "FILE"});
  command
      .add_option("--side", arguments->side,
                  "Surface that was imaged: atrial (default), the atrial side of the leaflets; "
                  "middle, their mid-surface")
      .one_of(std::vector<std::string>{"atrial", "middle"})
      .show_argument("SIDE");
  command
      .add_option(
          "--frame", arguments->frame,
          "Coordinate frame of the surface: patient (LPS; default if known to the valve) or valve")
      .one_of(std::vector<std::string>{"patient", "valve"})
      .show_argument("FRAME");
  command
      .add_option("--leak", arguments->leak_mm2,
                  "Imaged leak, mm2: an anatomic area, not a PISA estimate")
      .check(number_from(0.0, 2000.0));
  command.add_option("--leak-sd", arguments->leak_sd_mm2, "Standard deviation of --leak, mm2")
      .check(number_from(0.01, 1000.0))
      .show_default();
  command
      .add_option(
          "--known", arguments->known,
          "Do not fit these: slack (chordal lengths), tips, prestretch, stiffness (moduli of the "
          "leaflets above the transition), hidden (leaflet height hidden in coaptation)")
      .one_of({"slack", "tips", "prestretch", "stiffness", "hidden"})
      .count(1, 5);
  command
      .add_option("--slack-sd", unknowns.slack_sd,
                  "Prior standard deviation of chordal lengths, as a fraction of the length")
      .check(number_from(0.001, 0.2))
      .show_default();
  command
      .add_option("--tip-sd", unknowns.tip_sd_mm,
                  "Prior standard deviation of each coordinate of the papillary tips, mm")
      .check(number_from(0.01, 10.0))
      .show_default();
  command
      .add_option("--hidden-sd", unknowns.hidden_sd_mm,
                  "Prior standard deviation of the hidden height, mm")
      .check(number_from(0.01, 5.0))
      .show_default();
  command.add_flag("--ruptured", options.ruptures,
                   "Estimate for each scallop whether its marginal chordae are ruptured; the "
                   "fitted valve has the most probable combination");
  command.add_option("--points", options.most_points, "Maximum number of surface points to use")
      .check(number_from(100, 10000))
      .show_default();
  command.add_option("--rounds", options.most_rounds, "Maximum number of rounds of each pass")
      .check(number_from(1, 1000))
      .show_default();
  options.most_seconds = kMostSeconds;
  command
      .add_option("--seconds", options.most_seconds,
                  "Time limit, s; the best fit so far is then written and depends on the machine")
      .check(number_from(0.1, 1e6))
      .show_default();
  add_membrane_option(command, options.closure.membrane);
  add_threads_option(command, options.threads);
  command
      .add_option("--map", arguments->picture,
                  "Write a map of the remaining distance (PNG; meshes only)")
      .check({refuse_standard_output, "FILE"});
  command.add_flag("--json", arguments->json, "Print JSON (coapt.fit/1)");
  add_server_option(command, arguments->server);
  command.footer(
      "The fit adjusts parameters that images do not show, each within three standard deviations "
      "of\nits prior: chordal lengths by group and muscle, positions of the papillary tips, in "
      "vivo\nprestretch of the tissue, its stiffness above the transition, and leaflet height "
      "below "
      "the\ncoaptation line. It reports the posterior uncertainty of each parameter and which of "
      "them the data\ndo not constrain. The exit code is 3 if the fit stopped before convergence, "
      "if more than 2 mm rms\nremain, or if the surface has fewer independent points than there "
      "are parameters.\n\n"
      "Examples:\n"
      "  coapt fit valve.json --closed systole.stl -o fitted.json --map residual.png\n"
      "  coapt fit valve.json --closed systole.vtk --leak 35 --leak-sd 10 -o fitted.json --json\n"
      "  coapt fit flail.json --closed systole.stl --leak 40 --ruptured -o fitted.json\n"
      "  coapt fit valve.json --closed points.csv --frame valve --known tips hidden -o "
      "fitted.json");
  on_run_by(command, "fit", arguments->server, {"--threads"}, status,
            [arguments](const auto& service) { return run(*arguments, service); });
}

}  // namespace coapt
