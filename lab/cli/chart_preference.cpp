#include "lab/cli/chart_preference.h"

#include <iomanip>
#include <iostream>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "clients/cli/files.h"
#include "clients/cli/progress_bar.h"
#include "io/json/answers_json.h"
#include "lab/cli/chart_parts.h"
#include "lab/preference/preference_study.h"

namespace coapt {
namespace {

// Every second preset, in the order of `coapt valve make --help`, is held out.
constexpr const char* kAsked[] = {"porcine-1", "human-functional-mr", "barlow", "marfan"};
constexpr const char* kHeldOut[] = {"human-p2-prolapse", "fibroelastic-flail", "secondary-mr",
                                    "hypertrophic"};

/// Appends the plans of these presets; returns an exit code.
int read_cases_of(std::span<const char* const> presets, std::vector<PlanCase>& cases) {
  for (const std::string preset : presets) {
    const std::string path = std::string(COAPT_PREFERENCE_CASES) + '/' + preset + ".json";
    const Expected<std::string> text = read_input(path);
    if (!text) return report_errors(path, text.errors());
    const Expected<PlanCase> read = read_plan_case(*text);
    if (!read) return report_errors(path, read.errors());
    cases.push_back(*read);
    cases.back().name = preset;
  }
  return 0;
}

void print(std::ostream& out, const std::vector<PreferenceSummary>& all) {
  out << std::fixed << std::setprecision(3)
      << "noise  asking       answers  regret, mm2 (held out ± sd, share < 0.5)  covered"
         "  informed, covered\n";
  for (const PreferenceSummary& of : all)
    out << std::left << std::setw(7) << to_string(of.noise) << std::setw(13) << to_string(of.asking)
        << std::right << std::setw(7) << of.answers << std::setw(8) << of.regret_mm2 << " ("
        << of.held_out_regret_mm2 << " ± " << of.held_out_regret_sd_mm2 << ", " << of.below_half
        << ")" << std::setw(16) << of.covered << std::setw(10) << of.informed << ", "
        << of.informed_covered << '\n';
}

}  // namespace

void add_preference(Command chart, int& status) {
  const auto options = std::make_shared<PreferenceStudyOptions>();
  Command command = chart.add_command(
      "preference", "Learn the weights of simulated experts from their comparisons of plans");
  const auto directory = add_output(command);
  command.add_option("--experts", options->experts, "Of either noise")
      .check(number_from(1, 10000))
      .show_default();
  command.add_option("--answers", options->answers, "Of each expert")
      .check(number_from(5, 200))
      .show_default();
  command.add_option("--seed", options->seed, "Of experts and answers").show_default();
  add_threads_option(command, options->threads, "answers");
  command.footer(
      "Experts are drawn from the prior. Half of them answer with the noise that is assumed, half\n"
      "are sure of each answer and wrong in one of ten. They are asked about the plans of four\n"
      "presets; the weights that were learned then rank those of four others.\n\n"
      "Example:\n"
      "  coapt-lab chart preference -o charts");
  command.on_run([=, &status] {
    std::vector<PlanCase> asked, held_out;
    if ((status = read_cases_of(kAsked, asked)) != 0) return;
    if ((status = read_cases_of(kHeldOut, held_out)) != 0) return;
    std::vector<PreferenceOutcome> all;
    status = run_chart(*directory, "preference.csv", [&] {
      const ProgressBar bar;
      all = study_preference(asked, held_out, *options,
                             [&](int done, int planned) { bar.show(done, planned, "experts"); });
      return preference_csv(all);
    });
    print(std::cout, summaries(all));
  });
}

}  // namespace coapt
