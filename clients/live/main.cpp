// coapt-live: a valve under a haptic device.
#include <exception>
#include <iostream>
#include <optional>
#include <string>
#include <vector>

#include "clients/cli/plan_option.h"
#include "clients/cli/read_argument.h"
#include "clients/live/haply_device.h"
#include "clients/live/live_session.h"
#include "clients/live/session_report.h"
#include "clients/live/stylus_script.h"
#include "core/live/live_valve.h"
#include "core/valve/printable.h"
#include "io/command_line/exit_code.h"
#include "io/command_line/files.h"
#include "io/command_line/interrupt.h"
#include "io/json/result_json.h"
#include "io/json/version.h"

namespace coapt {
namespace {

constexpr int kMostSteps = 40000;  // until the valve has closed, before the hand comes

struct LiveArguments {
  std::string valve, device, record;
  PlanOption plan;
  std::optional<double> pressure_mmhg;
  SessionOptions session;
  bool json = false;
};

/// "stylus:FILE", "haply" or "haply:ws://HOST:PORT".
Expected<HapticDevice> open_device(const std::string& device, const Vec3& middle_mm) {
  if (device.starts_with("stylus:")) {
    const Expected<std::string> csv = read_input(device.substr(7));
    if (!csv) return csv.errors();
    Expected<std::vector<StylusSample>> script = read_stylus_script(*csv);
    if (!script) return script.errors();
    return scripted_stylus(*std::move(script));
  }
  if (device == "haply") return connect_haply(kHaplyService, middle_mm);
  if (device.starts_with("haply:")) return connect_haply(device.substr(6), middle_mm);
  return Error{ErrorCode::Unsupported, "",
               "is not a device; must be stylus:FILE, haply or haply:ws://HOST:PORT"};
}

int exit_code_of(SessionEnd end) {
  switch (end) {
    case SessionEnd::Device:
    case SessionEnd::Time:
      return exit_code::kOk;
    case SessionEnd::Interrupt:
      return exit_code::kInterrupted;
    case SessionEnd::Lost:
      return exit_code::kFailure;
  }
  return exit_code::kFailure;
}

/// Valves may close under more than a live one takes.
Errors pressure_problems(const Valve& valve) {
  ProblemList problems;
  check_range(problems, "/pressure_kpa", valve.pressure_kpa, kLiveSystoles_kpa,
              " kPa, or give --pressure");
  return std::move(problems).take();
}

/// The device is closed when this returns: its hand is free while figures are printed.
Expected<SessionResult> run_with_device(const LiveArguments& arguments, LiveValve& live,
                                        const std::atomic<bool>& interrupted) {
  const Vec3 middle_mm = live.vertices_mm().topRows(live.vertices()).colwise().mean().transpose() /
                         arguments.session.scale;
  const Expected<HapticDevice> device = open_device(arguments.device, middle_mm);
  if (!device) return device.errors();
  return run_session(live, *device, arguments.session, interrupted);
}

int run(const LiveArguments& arguments) {
  const std::atomic<bool>& interrupted = catch_interrupts();
  const PlannedValve planned = read_planned_valve(arguments.valve, arguments.plan);
  if (planned.failed != exit_code::kOk) return planned.failed;
  if (const int failed = check_output(arguments.record)) return failed;
  const Valve& valve = planned.repaired;
  if (const Errors problems = pressure_problems(valve);
      !arguments.pressure_mmhg && !problems.empty())
    return report_errors(arguments.valve, problems);
  LiveValve live(valve, arguments.pressure_mmhg.value_or(kMmhgPerKpa * valve.pressure_kpa));
  for (int done = 0; done < kMostSteps && !live.at_rest() && !interrupted; done += 60)
    live.advance(60);
  const Expected<SessionResult> session = run_with_device(arguments, live, interrupted);
  if (!session) {
    report_errors(arguments.device, session.errors());
    return session.errors().front().code == ErrorCode::InputOutput &&
                   arguments.device.starts_with("haply")
               ? exit_code::kFailure
               : exit_code::kBadInput;
  }
  for (const std::string& refused : session->real_time.refused)
    std::cerr << "coapt-live: " << refused << "; periods may be late\n";
  if (session->end == SessionEnd::Lost)
    std::cerr << "coapt-live: " << printable(arguments.device + ": " + session->lost) << '\n';
  if (arguments.json) {
    std::cout << json_text(to_json(*session, arguments.session.rate_hz), 2) << '\n';
  } else {
    print_session(std::cout, *session, arguments.session.rate_hz);
  }
  if (!arguments.record.empty())
    if (const int failed = write_output(arguments.record, session_csv(session->rows)))
      return failed;
  return exit_code_of(session->end);
}

void add_options(Command app, LiveArguments& arguments) {
  app.add_option("valve", arguments.valve, kValveHelp).required();
  add_plan_option(app, arguments.plan);
  app.add_option("--device", arguments.device,
                 "Haptic device: stylus:FILE, a script (CSV: t_ms, x, y, z, button; mm); haply, an "
                 "Inverse3 at ws://localhost:10001; or haply:ws://HOST:PORT")
      .required();
  app.add_option(
         "--pressure", arguments.pressure_mmhg,
         "Pressure of the ventricle relative to the atrium, mmHg (default: the valve's own)")
      .check(number_from(kLivePressures_mmhg.min, kLivePressures_mmhg.max))
      .show_argument("MMHG");
  app.add_option("--seconds", arguments.session.seconds,
                 "Duration, s (0: until the script ends or the device disconnects)")
      .check(number_from(0.0, 86400.0))
      .show_default();
  app.add_option("--rate", arguments.session.rate_hz, "Update rate, Hz")
      .check(number_from(10.0, 4000.0))
      .show_default();
  app.add_option("--scale", arguments.session.scale,
                 "Displacement in the valve per displacement of the stylus")
      .check(number_from(0.01, 100.0))
      .show_default();
  app.add_option("--record", arguments.record,
                 "Write each period of the first 600 s (CSV): position, force, energy, lateness")
      .check({refuse_standard_output, "FILE"});
  app.add_flag("--json", arguments.json, "Print JSON (coapt.live/1)");
}

int run(int argc, char** argv) {
  CommandLine line("coapt-live", "Renders a valve on a haptic device at 1,000 Hz.");
  Command app = line.program();
  LiveArguments arguments;
  add_options(app, arguments);
  app.footer(
      "The button grasps the nearest leaflet or chorda and releases it; the valve then beats once. "
      "Ctrl-C\nends the session.\n\n"
      "Examples:\n"
      "  coapt-live human-functional-mr --device haply\n"
      "  coapt-live human-p2-prolapse --device stylus:examples/live/pull.csv --record felt.csv\n\n"
      "Exit codes: 0 done; 1 the device was lost or an output could not be written; 2 bad input "
      "or\nusage; 130 interrupted, figures printed.");
  line.end_helps_with(std::string(kResearchNotice));
  if (const std::optional<int> ended = line.parse(argc, argv)) return *ended;
  arguments.session.record = !arguments.record.empty();
  const int status = run(arguments);
  if (std::cout.flush()) return status;
  std::cerr << "coapt-live: standard output: cannot be written\n";
  return exit_code::kFailure;
}

}  // namespace
}  // namespace coapt

int main(int argc, char** argv) {
  try {
    return coapt::run(argc, argv);
  } catch (const std::exception& error) {
    std::cerr << "coapt-live: " << coapt::printable(error.what()) << '\n';
    return coapt::exit_code::kFailure;
  }
}
