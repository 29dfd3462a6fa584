#include <cmath>
#include <filesystem>
#include <iomanip>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "clients/cli/commands.h"
#include "clients/cli/method_option.h"
#include "clients/cli/read_argument.h"
#include "core/valve/patient_frame.h"
#include "io/command_line/exit_code.h"
#include "io/command_line/files.h"
#include "io/command_line/interrupt.h"
#include "io/command_line/progress_bar.h"
#include "io/exchange/import_files.h"
#include "io/exchange/shape_file.h"
#include "io/json/fit_json.h"
#include "io/json/valve_json.h"
#include "io/mesh/import_readers.h"
#include "io/picture/fit_picture.h"
#include "io/picture/text.h"

namespace coapt {
namespace {

constexpr double kMostSeconds = 600.0;

enum class SurfaceFrame { Patient, Valve };

struct FitArguments {
  std::string valve, closed, output, picture;
  SurfaceFrame frame = SurfaceFrame::Patient;
  bool frame_given = false;
  MeasuredSide side = MeasuredSide::Atrial;
  std::optional<double> leak_mm2;
  double leak_sd_mm2 = MeasuredClosure{}.leak_sd_mm2;
  std::vector<std::string> known;
  FitOptions options;
  bool json = false;
};

/// Points of a mesh, with its triangles, or of a CSV table, without.
Expected<LeafletMesh> read_surface(const std::string& path) {
  const Expected<std::string> bytes = read_input(path);
  if (!bytes) return bytes.errors();
  const std::string format = format_of(path);
  if (is_shape_format(format)) return read_shape(*bytes, format);
  if (format != "csv")
    return Error{ErrorCode::Unsupported, "",
                 "must end in one of " + shape_format_names() + ", or in csv (x,y,z lines)"};
  const Expected<Points> points = read_points_csv(*bytes);
  if (!points) return points.errors();
  LeafletMesh cloud;
  cloud.vertices_mm = *points;
  return cloud;
}

/// Into the valve's frame.
Expected<LeafletMesh> placed(LeafletMesh surface, const Valve& valve,
                             const FitArguments& arguments) {
  if (arguments.frame == SurfaceFrame::Valve) return surface;
  if (valve.patient) {
    surface.vertices_mm = from_patient(*valve.patient, surface.vertices_mm);
    return surface;
  }
  if (arguments.frame_given)
    return Error{ErrorCode::MissingField, "/patient_frame",
                 "is missing in the valve: it was not made from images, or by an older version; "
                 "use --frame valve if the surface is in the valve's own frame"};
  return surface;
}

const char* why(FitStop stop) {
  switch (stop) {
    case FitStop::RoundLimit:
      return " (--rounds)";
    case FitStop::TimeLimit:
      return " (--seconds)";
    case FitStop::AtRest:
    case FitStop::Cancelled:
      return "";
  }
  return "";
}

/// Those of --ruptured, if it was given.
void print_hypotheses(std::ostream& out, const ValveFit& fit) {
  if (fit.hypotheses.empty()) return;
  out << "\n  " << std::left << std::setw(14) << "hypothesis" << std::right << std::setw(13)
      << "probability" << std::setw(9) << "rms, mm" << std::setw(11) << "leak, mm2"
      << "\n";
  for (const FitHypothesis& of : fit.hypotheses) {
    out << "  " << std::left << std::setw(14) << of.name << std::right << std::setw(13)
        << fixed(of.probability, 3);
    if (std::isnan(of.rms_mm))
      out << "  closure failed";
    else
      out << std::setw(9) << fixed(of.rms_mm, 3) << std::setw(11) << fixed(of.leak_mm2, 1)
          << (of.name == fit.taken ? "  selected"
              : of.refitted        ? ""
                                   : "  not fitted");
    out << '\n';
  }
  for (std::size_t i = 0; i < fit.left_out.size(); ++i)
    out << (i == 0 ? "skipped at the time limit: " : ", ") << fit.left_out[i];
  if (!fit.left_out.empty()) out << '\n';
}

void print_fit(std::ostream& out, const ValveFit& fit, const MeasuredClosure& measured) {
  out << "distance   " << fixed(fit.rms_before_mm, 3) << " mm rms before, " << fixed(fit.rms_mm, 3)
      << " mm after, of " << fit.points_mm.rows() << " points, equivalent to "
      << std::lround(fit.independent_points) << " independent points\n"
      << "leak       " << fixed(fit.before.measure.leak.area_mm2, 1) << " mm2 before, "
      << fixed(fit.leak.mm2, 1) << " ± " << fixed(fit.leak.sd_mm2, 1) << " mm2 after";
  if (measured.leak_mm2)
    out << " (given: " << fixed(*measured.leak_mm2, 1) << " ± " << fixed(measured.leak_sd_mm2, 1)
        << ')';
  out << "\n\n  " << std::left << std::setw(28) << "parameter" << std::right << std::setw(9)
      << "value" << std::setw(9) << "sd" << std::setw(9) << "before" << std::setw(9) << "sd"
      << "\n";
  for (const FittedParameter& fitted : fit.parameters) {
    const FitParameter& parameter = fitted.parameter;
    const bool mm = parameter.unit == "mm";
    out << "  " << std::left << std::setw(28) << (parameter.name + (mm ? ", mm" : ""))
        << std::right;
    for (const double number : {fitted.value, fitted.sd, parameter.prior, parameter.prior_sd})
      out << std::setw(9) << fixed(number, mm ? 2 : 3);
    out << (fitted.identifiable ? "" : "  weakly constrained by the data") << '\n';
  }
  print_hypotheses(out, fit);
  if (fit.stop != FitStop::AtRest) out << "\nstopped before convergence" << why(fit.stop) << '\n';
}

int run(FitArguments arguments) {
  for (const std::string& output : {arguments.output, arguments.picture})
    if (const int failed = check_output(output)) return failed;
  const Expected<Valve> valve = read_any_valve_argument(arguments.valve);
  if (!valve) return report_errors(arguments.valve, valve.errors());
  const Expected<LeafletMesh> read = read_surface(arguments.closed);
  if (!read) return report_errors(arguments.closed, read.errors());
  const Expected<LeafletMesh> surface = placed(*read, *valve, arguments);
  if (!surface) return report_errors(arguments.valve, surface.errors());
  for (const std::string& known : arguments.known) {
    FitUnknowns& unknowns = arguments.options.unknowns;
    (known == "slack"        ? unknowns.slack
     : known == "tips"       ? unknowns.tips
     : known == "prestretch" ? unknowns.prestretch
                             : unknowns.hidden) = false;
  }
  const MeasuredClosure measured{surface->vertices_mm, arguments.side, arguments.leak_mm2,
                                 arguments.leak_sd_mm2};
  Expected<ValveFit> fit = Error{};
  {
    const ProgressBar bar;
    const std::atomic<bool>& interrupted = catch_interrupts();
    arguments.options.cancelled = [&] { return interrupted.load(); };
    arguments.options.progress = [&](int round, double rms_mm) {
      bar.show(round, (arguments.options.ruptures ? 6 : 2) * arguments.options.most_rounds,
               "rounds (maximum), rms " + fixed(rms_mm, 3) + " mm");
      return true;
    };
    fit = fit_valve(*valve, measured, arguments.options);
  }
  if (!fit)
    return report_option_errors(
        "fit", fit.errors(),
        {{"/points_mm", "--closed"}, {"/leak_mm2", "--leak"}, {"/unknowns", "--known"}});
  Valve fitted = fit->closed.valve;
  const std::string surface_name = std::filesystem::path(arguments.closed).filename().string();
  fitted.provenance.push_back(fit_sentence(*fit, surface_name));
  if (const int failed = write_output(arguments.output, write_valve(fitted))) return failed;
  if (!arguments.picture.empty())
    if (const int failed = write_output(arguments.picture,
                                        fit_map_png(*surface, *fit, arguments.side, surface_name)))
      return failed;
  if (arguments.json)
    std::cout << fit_to_json(*fit, {arguments.valve, arguments.closed, measured}).dump(2) << '\n';
  else
    print_fit(std::cout, *fit, measured);
  const std::vector<std::string> doubts = doubts_of(*fit);
  for (const std::string& doubt : doubts)
    std::cerr << "coapt: fit: check this against the images: " << doubt << ".\n";
  return fit->stop == FitStop::AtRest && doubts.empty() ? exit_code::kOk : exit_code::kNotClosed;
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
  const std::map<std::string, MeasuredSide> sides = {{"atrial", MeasuredSide::Atrial},
                                                     {"middle", MeasuredSide::Middle}};
  command
      .add_choice("--side", arguments->side, sides,
                  "Surface that was imaged: atrial (default), the atrial side of the leaflets; "
                  "middle, their mid-surface")
      .show_argument("SIDE");
  const std::map<std::string, SurfaceFrame> frames = {{"patient", SurfaceFrame::Patient},
                                                      {"valve", SurfaceFrame::Valve}};
  command
      .add_choice(
          "--frame", arguments->frame, frames,
          "Coordinate frame of the surface: patient (LPS; default if known to the valve) or valve")
      .show_argument("FRAME");
  command
      .add_option("--leak", arguments->leak_mm2,
                  "Imaged leak, mm2: an anatomic area, not a PISA estimate")
      .check(number_from(0.0, 2000.0));
  command.add_option("--leak-sd", arguments->leak_sd_mm2, "Standard deviation of --leak, mm2")
      .check(number_from(0.01, 1000.0))
      .show_default();
  command
      .add_option("--known", arguments->known,
                  "Do not fit these: slack (chordal lengths), tips, prestretch, hidden (leaflet "
                  "height hidden in coaptation)")
      .one_of({"slack", "tips", "prestretch", "hidden"})
      .count(1, 4);
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
  command
      .add_option("--threads", options.threads,
                  "Number of threads (0: all cores); does not change the result")
      .check(number_from(0, 1024))
      .show_default();
  command
      .add_option("--map", arguments->picture,
                  "Write a map of the remaining distance (PNG; meshes only)")
      .check({refuse_standard_output, "FILE"});
  command.add_flag("--json", arguments->json, "Print JSON (coapt.fit/1)");
  command.footer(
      "The fit adjusts parameters that images do not show, each within three standard deviations "
      "of\nits prior: chordal lengths by group and muscle, positions of the papillary tips, in "
      "vivo\nprestretch of the tissue, and leaflet height below the coaptation line. It reports "
      "the\nposterior uncertainty of each parameter and which of them the data do not constrain. "
      "The exit\ncode is 3 if the fit stopped before convergence, if more than 2 mm rms remain, or "
      "if the\nsurface has fewer independent points than there are parameters.\n\n"
      "Examples:\n"
      "  coapt fit valve.json --closed systole.stl -o fitted.json --map residual.png\n"
      "  coapt fit valve.json --closed systole.vtk --leak 35 --leak-sd 10 -o fitted.json --json\n"
      "  coapt fit flail.json --closed systole.stl --leak 40 --ruptured -o fitted.json\n"
      "  coapt fit valve.json --closed points.csv --frame valve --known tips hidden -o "
      "fitted.json");
  command.on_run([arguments, command, &status] {
    arguments->frame_given = command.has("--frame");
    status = run(*arguments);
  });
}

}  // namespace coapt
