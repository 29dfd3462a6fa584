#include <iostream>
#include <memory>
#include <sstream>
#include <string>

#include "clients/cli/commands.h"
#include "clients/cli/farm_option.h"
#include "clients/cli/run_options.h"
#include "clients/cli/study_directory.h"
#include "core/presets/presets.h"
#include "core/valve/number_text.h"
#include "io/command_line/command_line.h"
#include "io/command_line/exit_code.h"
#include "io/command_line/files.h"
#include "io/json/valve_json.h"
#include "io/picture/study_csv.h"
#include "io/picture/study_page.h"
#include "io/picture/text.h"
#include "search/studies/anchor_findings.h"
#include "search/studies/calibration.h"
#include "search/studies/thesis_study.h"

namespace coapt {
namespace {

struct StudyCalibrateArguments {
  std::string directory = "study-calibrate", farm;
  int starts = 1;
  bool anchors = false;
  CalibrationOptions calibration;
};

/// How many of the nine comparisons of figure 4.10 (mean, sd, sd of means; three classes) come out for the
/// trigone by the thesis's look-up.
int anchor_statement(StudyDirectory& directory, const Calibration& fit) {
  const Expected<Valve> valve = make_taut_valve(parametric_valve(fit.anatomy, "calibrated"));
  if (!valve) return 0;
  OrificeTable table = directory.table(*valve);
  int holds = 0;
  for (const Finding& finding :
       anchor_findings(study_approximation(table, Protocol::LookupClamped, thesis_anchors(*valve))))
    if (finding.agrees && finding.finding.find("/trigone-smaller") != std::string::npos) ++holds;
  return holds;
}

std::vector<std::vector<std::string>> fit_table(const Calibration& fit) {
  std::vector<std::vector<std::string>> rows = {{"orifice, mm2", "thesis", "ours", "difference"}};
  const std::vector<CalibrationTarget> targets = calibration_targets();
  for (std::size_t k = 0; k < targets.size(); ++k)
    rows.push_back({targets[k].name, fixed(targets[k].area_mm2, 1), fixed(fit.area_mm2[k], 1),
                    fixed(fit.area_mm2[k] - targets[k].area_mm2, 1)});
  return rows;
}

std::vector<std::vector<std::string>> anatomy_table(const Calibration& fit) {
  std::vector<std::vector<std::string>> rows = {
      {"parameter", "fitted", "least", "most", "at a bound"}};
  for (std::size_t i = 0; i < fit.anatomy.size(); ++i) {
    const AnatomyParameter& p = anatomy_parameters()[i];
    const double share = (fit.anatomy[i] - p.lower) / (p.upper - p.lower);
    rows.push_back({p.name, significant(fit.anatomy[i], 5), significant(p.lower, 5),
                    significant(p.upper, 5), share < 0.01 || share > 0.99 ? "yes" : ""});
  }
  return rows;
}

int run(const StudyCalibrateArguments& arguments) {
  const Expected<std::unique_ptr<StudyDirectory>> opened = StudyDirectory::open(
      arguments.directory,
      {arguments.calibration.threads, arguments.farm, "coapt study calibrate"});
  if (!opened) {
    report_errors("study calibrate", opened.errors());
    return exit_code::kFailure;
  }
  StudyDirectory& directory = **opened;
  Calibration best;
  int best_holds = -1;
  for (int start = 0; start < arguments.starts; ++start) {
    CalibrationOptions options = arguments.calibration;
    options.seed += static_cast<std::uint64_t>(start);
    options.progress = [&](int round, double cost) {
      directory.show(round, options.most_rounds,
                     "rounds of start " + std::to_string(start + 1) + ", cost " + fixed(cost, 2));
      return true;
    };
    const Calibration fit = calibrate(options);
    directory.begin("anchors of start " + std::to_string(start + 1));
    const int holds = arguments.anchors ? anchor_statement(directory, fit) : 0;
    std::cout << "seed " << options.seed << ": Spearman " << fixed(fit.spearman, 3) << ", rms "
              << fixed(fit.rms_mm2, 1) << " mm2 over table 4.1, dilation within "
              << fixed(100.0 * fit.largest_dilation_error, 0) << " %, " << fit.untrusted
              << " not trusted, " << counted(fit.closures, "closure");
    if (arguments.anchors) std::cout << ", anchors " << holds << " of 9";
    std::cout << std::endl;
    if (holds < best_holds || (holds == best_holds && fit.rms_mm2 >= best.rms_mm2)) continue;
    best = fit;
    best_holds = holds;
  }
  const Expected<Valve> valve = make_taut_valve(parametric_valve(best.anatomy, "calibrated"));
  if (!valve) return report_errors("study calibrate", valve.errors());
  const std::string page =
      study_page("A valve calibrated to the thesis", "Figure 4.5 and table 4.1, number by number.",
                 {{"Fit", "", "", fit_table(best)}, {"Anatomy", "", "", anatomy_table(best)}});
  for (const auto& [name, content] :
       {std::pair<std::string, std::string>{"valve.json", write_valve(*valve)},
        {"fit.csv", table_csv(fit_table(best))},
        {"anatomy.csv", table_csv(anatomy_table(best))},
        {"index.html", page}})
    if (const int error = directory.write(name, content)) return error;
  std::cout << "Written to " << printable(arguments.directory) << "/valve.json and index.html\n";
  return exit_code::kOk;
}

}  // namespace

void add_calibrate(Command parent, int& status) {
  const auto arguments = std::make_shared<StudyCalibrateArguments>();
  CalibrationOptions& calibration = arguments->calibration;
  Command command = parent.add_command(
      "calibrate", "Fit a parametric valve to the thesis's figure 4.5 and table 4.1");
  command.add_option("-o,--output", arguments->directory, "Directory for the valve and its fit")
      .show_default();
  add_seed_option(command, calibration.seed, "Seed of the first start");
  command
      .add_option(
          "--spread", calibration.spread,
          "Fraction of each range, on either side, from which the first anatomies are drawn")
      .check(number_from(0.0, 1.0))
      .show_default();
  command
      .add_option("--starts", arguments->starts,
                  "Number of seeds to fit from; the best fit is kept")
      .check(number_from(1, 1000))
      .show_default();
  command.add_option("--rounds", calibration.most_rounds, "Maximum number of rounds of a fit")
      .check(number_from(1, 1000))
      .show_default();
  command.add_flag(
      "--anchors", arguments->anchors,
      "Keep the fit that agrees best with the thesis's statement on anchors, using its look-up");
  add_threads_option(command, calibration.threads);
  add_farm_option(command, arguments->farm,
                  "Compute the closures of --anchors, but not the fit itself,");
  command.footer(
      "Each start takes about 20,000 closures. An interrupted fit restarts from the beginning.\n\n"
      "Examples:\n"
      "  coapt study calibrate --seed 2 --spread 0.1 -o tables\n"
      "  coapt study calibrate --starts 4 --anchors -o with-anchors");
  command.on_run([arguments, &status] { status = run(*arguments); });
}

}  // namespace coapt
