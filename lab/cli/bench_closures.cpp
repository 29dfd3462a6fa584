#include <iostream>
#include <memory>
#include <string>

#include "clients/cli/method_option.h"
#include "clients/cli/read_argument.h"
#include "core/metrics/quantile.h"
#include "core/presets/presets.h"
#include "io/command_line/command_line.h"
#include "io/command_line/exit_code.h"
#include "io/command_line/files.h"
#include "io/command_line/progress_bar.h"
#include "io/json/plan_json.h"
#include "io/json/result_json.h"
#include "lab/cli/commands.h"
#include "lab/closures/study_json.h"
#include "search/studies/generality.h"

namespace coapt {
namespace {

constexpr const char* kAnatomies = "anatomies";
constexpr const char* kPresets = "presets";

struct BenchArguments {
  std::string valve;
  ClosureStudyOptions study;
  std::optional<double> accuracy_mm2;
  bool no_accuracy = false, json = false;
};

void print(std::ostream& out, const ClosureStudy& study, const ClosureStudyOptions& options) {
  std::vector<double> rms, leak;
  for (const SceneOutcome& scene : study.scenes) {
    if (!scene.compared) continue;
    rms.push_back(scene.from_end.rms_mm);
    leak.push_back(std::abs(scene.from_end.leak_mm2));
  }
  out << study.scenes.size() << " closures: median " << study.median_ms << " ms, 90 % below "
      << study.p90_ms << " ms, " << study.closures_per_second_per_core << " a second and core\n"
      << study.unconverged << " not converged, " << study.crossed << " crossed, " << study.retried
      << " needed more than one attempt\n";
  for (std::size_t i = 0; i < study.scenes.size(); ++i)
    if (study.scenes[i].status != ClosureStatus::Converged || study.scenes[i].crossing)
      out << "scene " << i << ": " << to_string(study.scenes[i].status)
          << (study.scenes[i].crossing ? ", crossed\n" : "\n");
  if (options.predicted)
    out << study.not_predicted << " could not be predicted; the seven closures around each: "
        << study.frames_per_second_per_core << " scenes a second and core\n";
  if (options.library > 0)
    out << study.not_predicted
        << " started from the nearest of the library, because the mean of it crossed; the "
           "libraries took "
        << study.library_seconds << " s of a core\n";
  if (!options.accuracy) return;
  out << "Distance from the equilibrium (residual 1e-6): rms median " << quantile(rms, 0.5)
      << ", 90 % below " << quantile(rms, 0.9) << " mm; leak 90 % below " << quantile(leak, 0.9)
      << " mm2\n"
      << study.other_equilibria << " of " << study.compared
      << " reach another equilibrium (0.05 mm rms or more) when closed differently; their leaks "
         "differ by "
      << study.leak_difference_p90_mm2 << " (90 % below), at most by "
      << study.leak_difference_max_mm2 << " mm2\n";
}

/// Puts the tolerances for --accuracy, if it was given, into `closure` and says on standard error
/// which they are. Errors point to "/accuracy".
Expected<std::optional<AccuracyTier>> apply_accuracy(std::optional<double> accuracy_mm2,
                                                     ClosureOptions& closure) {
  if (!accuracy_mm2) return std::optional<AccuracyTier>();
  if (closure.method != Method::Fast)
    return Error{ErrorCode::Unsupported, "/accuracy",
                 "is available only for method fast; leave out --method thesis"};
  const Expected<AccuracyTier> tier = choose_tier(*accuracy_mm2, closure.membrane);
  if (!tier) return tier.errors();
  closure = at_tier(closure, *tier);
  const TierError& error = error_of(*tier, closure.membrane);
  std::cerr << "coapt-lab: accuracy: residual " << tier->residual_tolerance << ", predicted way "
            << tier->way_tolerance_mm << " mm, membrane " << to_string(closure.membrane)
            << ": leak within " << error.p99_mm2
            << " mm2 of the equilibrium of this mesh in 99 of 100 "
            << "measured scenes, " << error.max_mm2 << " in all, at " << error.relative_time
            << " times the default's time; the mesh error is not included\n";
  return std::optional<AccuracyTier>(*tier);
}

/// The one that is named, all presets, or anatomies that no preset resembles, one for each scene.
Expected<std::vector<Valve>> read_valves(const BenchArguments& arguments) {
  if (arguments.valve == kAnatomies)
    return random_anatomies(arguments.study.count, arguments.study.seed, arguments.study.threads)
        .valves;
  if (arguments.valve == kPresets) {
    std::vector<Valve> valves;
    for (const std::string& name : preset_names()) valves.push_back(*make_preset(name));
    return valves;
  }
  const Expected<Valve> valve = read_valve_argument(arguments.valve);
  if (!valve) return valve.errors();
  return std::vector<Valve>{*valve};
}

/// One way to start, and of method fast.
Errors check_start(const ClosureStudyOptions& options) {
  ProblemList problems;
  const char* first = nullptr;
  for (const auto& [name, given] : {std::pair("warm", options.warm),
                                    {"predicted", options.predicted},
                                    {"library", options.library > 0}}) {
    if (!given) continue;
    const std::string path = std::string("/") + name;
    if (options.closure.method != Method::Fast)
      problems.add(ErrorCode::Unsupported, path,
                   "is available only for method fast; leave out --method thesis");
    if (first != nullptr)
      problems.add(ErrorCode::Unsupported, path,
                   std::string("cannot be combined with --") + first + "; leave out one of them");
    else
      first = name;
  }
  return std::move(problems).take();
}

int run(const BenchArguments& arguments) {
  const Expected<std::vector<Valve>> valves = read_valves(arguments);
  if (!valves) return report_errors(arguments.valve, valves.errors());
  ClosureStudyOptions options = arguments.study;
  options.accuracy = !arguments.no_accuracy;
  const auto accuracy = apply_accuracy(arguments.accuracy_mm2, options.closure);
  if (!accuracy) return report_option_errors("bench closures", accuracy.errors());
  if (const Errors errors = check_start(options); !errors.empty())
    return report_option_errors("bench closures", errors);
  const ClosureStudy study = [&] {
    const ProgressBar bar;
    return study_closures(*valves, options,
                          [&](int done) { bar.show(done, options.count, "scenes"); });
  }();
  if (arguments.json) {
    auto json = to_json(options, study);
    if (*accuracy) json["accuracy"] = to_json(**accuracy, options.closure.membrane);
    std::cout << json.dump(2) << '\n';
  } else {
    print(std::cout, study, options);
  }
  return study.unconverged + study.crossed == 0 ? exit_code::kOk : exit_code::kNotClosed;
}

}  // namespace

void add_bench_closures(Command parent, int& status) {
  const auto arguments = std::make_shared<BenchArguments>();
  Command command = parent.add_command(
      "closures", "Measure speed and accuracy of closures on many variations of a valve");
  ClosureStudyOptions& study = arguments->study;
  command
      .add_option("valve", arguments->valve,
                  std::string(kValveHelp) +
                      "; or presets, for all presets in turn; or anatomies, for a random anatomy "
                      "per variation")
      .required();
  command.add_option("--count", study.count, "Number of variations")
      .check(number_from(1, 1'000'000))
      .show_default();
  command.add_option("--seed", study.seed, "Random seed; the same seed gives the same variations")
      .check(number_from(std::uint64_t{0}, std::numeric_limits<std::uint64_t>::max()))
      .show_default();
  command
      .add_option("--threads", study.threads,
                  "Number of threads (0: all cores); does not change the closures")
      .check(number_from(0, 1024))
      .show_default();
  add_method_option(command, study.closure.method);
  add_membrane_option(command, study.closure.membrane);
  command
      .add_option("--accuracy", arguments->accuracy_mm2,
                  "Use the fastest tolerances that kept the error of the leak from the stopping "
                  "criterion below this value, mm2, in 99 of 100 test cases (method fast)")
      .check(number_from(0.0, std::numeric_limits<double>::max()))
      .show_argument("MM2");
  command.add_flag("--no-accuracy", arguments->no_accuracy,
                   "Skip the two further closures of each variation that errors are measured from");
  command.add_flag("--warm", study.warm,
                   "Start each closure from that of a neighbour with tips within 1 mm, and compare "
                   "with a cold start instead of a closure at half the speed");
  command.add_flag("--predicted", study.predicted,
                   "Start each closure from a prediction by seven neighbours with tips within 1 "
                   "mm, timed separately, and compare with a cold start");
  command
      .add_option("--library", study.library,
                  "Start each closure from this many other closed variations of its valve, 40 for "
                  "instance, timed separately, and compare with a cold start; 0: do not")
      .check(number_from(0, 1000))
      .show_default();
  command.add_flag("--json", arguments->json, "Print JSON");
  command.footer(
      "Variations: AP dilation 0 to 30 %, annular height 80 to 120 %, tips displaced by up to\n"
      "6 mm, rings and papillary sutures on 40 % each. Times are the processor's, of whole\n"
      "closures from the open state (with --warm, --predicted and --library: from others, of a\n"
      "prepared valve), further attempts and crossing tests included. Exit code 3 if a closure\n"
      "did not converge or leaflets cross.\n\n"
      "Examples:\n"
      "  coapt-lab bench closures human-normal --count 200\n"
      "  coapt-lab bench closures human-normal --count 200 --warm\n"
      "  coapt-lab bench closures human-normal --count 200 --predicted\n"
      "  coapt-lab bench closures human-normal --count 200 --library 40\n"
      "  coapt-lab bench closures presets --count 300\n"
      "  coapt-lab bench closures anatomies --count 100 --seed 7\n"
      "  coapt-lab bench closures porcine-1 --count 20 --method thesis --json");
  command.on_run([arguments, &status] { status = run(*arguments); });
}

}  // namespace coapt
