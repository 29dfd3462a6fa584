#include <iostream>
#include <memory>
#include <string>

#include "clients/cli/commands.h"
#include "clients/cli/farm_option.h"
#include "clients/cli/run_options.h"
#include "clients/cli/study_directory.h"
#include "core/presets/porcine_thesis.h"
#include "core/presets/presets.h"
#include "io/command_line/command_line.h"
#include "io/command_line/exit_code.h"
#include "io/command_line/files.h"
#include "io/picture/anchor_question_chart.h"
#include "io/picture/study_csv.h"
#include "io/picture/study_page.h"
#include "io/picture/text.h"

namespace coapt {
namespace {

struct StudyAnchorsArguments {
  std::string directory = "study-anchors", farm;
  int threads = 0;
  AnchorQuestionOptions question;
};

std::vector<std::vector<std::string>> answer_table(const std::vector<AnchorAnswer>& answers) {
  std::vector<std::vector<std::string>> rows = {
      {"protocol", "class", "less", "anatomies", "trigone wins", "ties", "mean difference"}};
  for (const ScanFactor& factor : scan_factors())
    rows[0].push_back(std::string(factor.name) + ": share, effect");
  rows[0].emplace_back("Q2");
  for (const AnchorAnswer& a : answers) {
    rows.push_back({to_string(a.protocol), to_string(a.displaced), to_string(a.objective),
                    std::to_string(a.anatomies), std::to_string(a.trigone_wins),
                    std::to_string(a.ties), fixed(a.mean_difference, 2)});
    for (std::size_t f = 0; f < a.decided_by.total.size(); ++f)
      rows.back().push_back(fixed(a.decided_by.total[f], 2) + ", " +
                            fixed(a.decided_by.effect[f], 2));
    rows.back().push_back(fixed(a.decided_by.predicted_share, 2));
  }
  return rows;
}

int run(const StudyAnchorsArguments& arguments) {
  const Expected<std::unique_ptr<StudyDirectory>> opened = StudyDirectory::open(
      arguments.directory, {arguments.threads, arguments.farm, "coapt study anchors"});
  if (!opened) {
    report_errors("study anchors", opened.errors());
    return exit_code::kFailure;
  }
  StudyDirectory& directory = **opened;
  AnchorQuestionOptions question = arguments.question;
  question.at_once = directory.valves_at_once();
  directory.begin("anatomy 1 of " + std::to_string(question.anatomies));
  question.progress = [&](int done, int planned) {
    directory.begin("anatomy " + std::to_string(done + 1) + " of " + std::to_string(planned));
  };
  const std::vector<ScannedAnatomy> scan = scan_anchors(
      porcine_thesis_tables(),
      [&](const Valve& valve) { return directory.table(valve, ClosureOptions{}); }, question);
  const std::vector<AnchorAnswer> answers = answer_anchor_question(scan);
  int competent = 0, closures = 0;
  for (const ScannedAnatomy& scanned : scan) {
    if (scanned.competent) ++competent;
    closures += scanned.closures;
  }
  const std::string lead =
      std::to_string(competent) + " of " + std::to_string(scan.size()) +
      " anatomies are competent when undisturbed and were studied, each at its displacements of 6 "
      "mm along any axes that leak more than 20 mm2, with " +
      counted(question.approximation.region_points, "node") + " of each region.";
  const std::string svg = anchor_question_svg(answers);
  const std::string page =
      study_page("Anatomies in which the trigone is the better anchor", lead,
                 {{"Fraction of anatomies where the trigone is better",
                   "At 50 % the anatomy decides, not the anchor.",
                   svg,
                   {}},
                  {"Most influential factors",
                   "Total Sobol index of each factor for the difference between trigone and saddle "
                   "peak, and the change of that difference from the low to the high end of the "
                   "factor. Q2 is the fraction of variance predicted for held-out anatomies; below "
                   "0.5 the indices are unreliable.",
                   "", answer_table(answers)}});
  for (const auto& [name, content] :
       {std::pair<std::string, std::string>{"scan.csv", anchor_scan_csv(scan)},
        {"answers.csv", anchor_answers_csv(answers)},
        {"anchors.svg", svg},
        {"index.html", page}})
    if (const int error = directory.write(name, content)) return error;
  for (const AnchorAnswer& a : answers)
    std::cout << to_string(a.protocol) << ", " << to_string(a.displaced) << ", "
              << to_string(a.objective) << ": trigone wins in " << a.trigone_wins << " of "
              << a.anatomies << " (" << a.ties << " ties)\n";
  std::cout << lead << ' ' << closures << " new closures in " << fixed(directory.seconds(), 0)
            << " s.\nWritten to " << printable(arguments.directory) << "/index.html\n";
  return exit_code::kOk;
}

}  // namespace

void add_anchor_question(Command parent, int& status) {
  const auto arguments = std::make_shared<StudyAnchorsArguments>();
  Command command =
      parent.add_command("anchors", "Find the anatomies in which the trigone is the better anchor");
  command.add_option("-o,--output", arguments->directory, "Directory for CSV, SVG, index.html")
      .show_default();
  command
      .add_option("--anatomies", arguments->question.anatomies,
                  "Number of anatomies, drawn by Latin hypercube sampling")
      .check(number_from(1, 10000))
      .show_default();
  add_seed_option(command, arguments->question.seed, "Seed of the Latin hypercube");
  command
      .add_option("--region-points", arguments->question.approximation.region_points,
                  "Number of points of the region of interest to close, out of 1,089")
      .check(number_from(17, 1089))
      .show_default();
  add_threads_option(command, arguments->threads);
  add_farm_option(command, arguments->farm, "Compute the closures");
  command.footer(
      "Papillary tips, trigones, saddle and leaflet reserve vary around preset "
      "porcine-thesis-tables. Each\nanatomy takes a few thousand closures. An interrupted scan "
      "resumes when run again with the same\ndirectory.\n\n"
      "Examples:\n"
      "  coapt study anchors --anatomies 64 -o anchors\n"
      "  coapt study anchors --anatomies 512 --farm postgresql://farm.example/coapt -o anchors");
  command.on_run([arguments, &status] { status = run(*arguments); });
}

}  // namespace coapt
