#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "clients/cli/commands.h"
#include "clients/cli/plan_option.h"
#include "clients/cli/print.h"
#include "clients/cli/print_table.h"
#include "clients/cli/read_argument.h"
#include "core/valve/number_text.h"
#include "io/command_line/command_line.h"
#include "io/command_line/exit_code.h"
#include "io/command_line/files.h"
#include "io/command_line/interrupt.h"
#include "io/command_line/progress_bar.h"
#include "io/json/model_study_json.h"
#include "io/picture/histogram_chart.h"
#include "io/picture/study_csv.h"
#include "io/picture/study_page.h"
#include "io/picture/text.h"
#include "search/model_draw.h"
#include "search/studies/model_study.h"

namespace coapt {
namespace {

struct StudyModelArguments {
  std::string valve, directory = "study-model";
  PlanOption plan;
  ModelStudyOptions study;
  bool json = false;
};

TableRows areas_table(const ModelStudy& study) {
  TableRows rows = {{"mm2", "nominal", "mean", "tissue ±", "5 %", "95 %"}};
  const ModelUncertainty& leak = study.leak;
  rows.push_back({"leak", fixed(leak.as_it_is_mm2, 1), fixed(leak.mean_mm2, 1),
                  fixed(leak.sd_mm2, 1), fixed(leak.p5_mm2, 1), fixed(leak.p95_mm2, 1)});
  return rows;
}

TableRows parameters_table(const ModelStudy& study) {
  TableRows rows = {{"parameter", "from", "to", "first", "total", "effect"}};
  for (int i = 0; i < kModelParameters; ++i) {
    const ModelParameter& parameter = model_parameters()[i];
    rows.push_back({parameter.name, shown(parameter.lower), shown(parameter.upper)});
    const SobolIndices& by = study.leak.decided_by;
    for (const auto& [values, decimals] :
         {std::pair{by.first, 2}, std::pair{by.total, 2}, std::pair{by.effect, 1}})
      rows.back().push_back(values.empty() ? "n/a" : fixed(values[i], decimals));
  }
  return rows;
}

std::string lead_of(const ModelStudy& study) {
  return counted(static_cast<long>(study.draws.size()), "draw") + " of tissue and chordae, " +
         std::to_string(study.untrusted) + " excluded as unreliable." +
         (study.observed.empty()
              ? ""
              : (study.contradicts ? " The observation "
                                   : " They are weighted by the observations of the valve and ") +
                    weight_words(study.contradicts, study.effective) + ".");
}

std::string decides_words(const ModelStudy& study) {
  return "First-order and total Sobol indices of each parameter, given as a factor of the valve's "
         "own value, and the change of the leak from the low to the high end of the parameter, "
         "mm2. Fraction of variance predicted for held-out variants (Q2; below 0.5 the indices are "
         "unreliable): " +
         fixed(study.leak.decided_by.predicted_share, 2) + ".";
}

std::string page_of(const ModelStudy& study, const std::string& valve) {
  HistogramChart chart{"", "", {}, 1};
  Sample sample{"leak over the variants", {}};
  for (const ModelStudyDraw& draw : study.draws)
    if (draw.trusted) sample.values.push_back(draw.leak_mm2);
  chart.panels.push_back({{"leak", "leak, mm²", "draws"}, "mm²", {std::move(sample)}});
  return study_page(
      "Tissue error of the leak: " + valve, lead_of(study),
      {{"Distribution of the leak", "", histogram_chart_svg(chart), areas_table(study)},
       {"Sensitivity of the leak", decides_words(study), "", parameters_table(study)}});
}

int write_all(const StudyModelArguments& arguments, const ModelStudy& study,
              const std::string& json, const std::string& valve) {
  for (const auto& [name, content] : {std::pair<std::string, std::string>{"model.json", json},
                                      {"areas.csv", table_csv(areas_table(study))},
                                      {"parameters.csv", table_csv(parameters_table(study))},
                                      {"draws.csv", model_draws_csv(study)},
                                      {"index.html", page_of(study, valve)}})
    if (const int failed = write_output(arguments.directory + "/" + name, content)) return failed;
  return exit_code::kOk;
}

int exit_code_of(const ModelStudy& study, bool interrupted) {
  if (interrupted) return exit_code::kInterrupted;
  return trusted(study.as_it_is) ? exit_code::kOk : exit_code::kNotClosed;
}

int run(StudyModelArguments arguments) {
  const std::atomic<bool>& interrupted = catch_interrupts();
  const PlannedValve given = read_planned_valve(arguments.valve, arguments.plan);
  if (given.failed) return given.failed;
  if (const Errors errors = make_directory(arguments.directory); !errors.empty()) {
    report_errors("study model", errors);
    return exit_code::kFailure;
  }
  arguments.study.cancelled = &interrupted;
  if (!given.plan.steps.empty() && !given.valve.observed.empty())
    arguments.study.unrepaired = &given.valve;
  const auto study_it = [&] {
    const ProgressBar bar;
    arguments.study.progress = [&](int done, int planned) {
      if (done % 8 == 0 || done == planned) bar.show(done, planned, "closures");
    };
    return study_model(given.repaired, arguments.study);
  };
  const ModelStudy study = study_it();
  const std::string json = to_json(study, given.valve.name).dump(2) + "\n";
  if (const int failed = write_all(arguments, study, json, given.valve.name)) return failed;
  if (arguments.json) {
    std::cout << json;
    return exit_code_of(study, interrupted);
  }
  std::cout << printable(given.valve.name) << ": " << lead_of(study) << "\n\n";
  print_table(std::cout, areas_table(study));
  std::cout << "\n" << decides_words(study) << "\n\n";
  print_table(std::cout, parameters_table(study));
  std::cout << "\nWritten to " << arguments.directory << "/index.html\n";
  return exit_code_of(study, interrupted);
}

}  // namespace

void add_study_model(Command parent, int& status) {
  const auto arguments = std::make_shared<StudyModelArguments>();
  Command command = parent.add_command(
      "model", "Analyse the sensitivity of leak and orifice to uncertain tissue and chordae");
  command.add_option("valve", arguments->valve, kValveHelp).required();
  add_plan_option(command, arguments->plan);
  command
      .add_option("--draws", arguments->study.draws,
                  "Number of variants of tissue and chordae to close")
      .check(number_from(1, 100000))
      .show_default();
  command.add_option("--seed", arguments->study.seed, "Seed of the Latin hypercube")
      .check(number_from(std::uint64_t{0}, std::uint64_t{1} << 62))
      .show_default();
  command.add_option("-o,--output", arguments->directory, "Directory for JSON, CSV and index.html")
      .show_default();
  command
      .add_option("--threads", arguments->study.threads,
                  "Number of threads (0: all cores); does not change the result")
      .check(number_from(0, 1024))
      .show_default();
  command.add_flag("--json", arguments->json, "Print JSON");
  command.footer(
      "Bending rigidity, insertion zones, thickness, moduli, transition strains and chordae vary "
      "within\nthe ranges of their sources, as factors of the valve's own values; half of the "
      "variants lie on\neach side of these. Neochordae keep their length. All variants are closed "
      "on this machine, not on a\nfarm.\n\n"
      "Examples:\n"
      "  coapt study model human-functional-mr -o model\n"
      "  coapt study model valve.json --plan plans.json --rank 2 --draws 128 --json");
  command.on_run([arguments, &status] { status = run(*arguments); });
}

}  // namespace coapt
