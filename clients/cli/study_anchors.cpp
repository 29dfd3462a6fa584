#include <iostream>
#include <memory>
#include <string>

#include "clients/cli/commands.h"
#include "clients/cli/exit_code.h"
#include "clients/cli/files.h"
#include "clients/cli/number_option.h"
#include "clients/cli/study_desk.h"
#include "core/presets/presets.h"
#include "io/picture/anchor_question_chart.h"
#include "io/picture/study_csv.h"
#include "io/picture/study_page.h"
#include "io/picture/text.h"

namespace coapt {
namespace {

struct StudyAnchorsArguments {
  std::string directory = "study-anchors";
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
  const Expected<std::unique_ptr<StudyDesk>> opened =
      StudyDesk::open(arguments.directory, arguments.threads);
  if (!opened) {
    report_errors("study anchors", opened.errors());
    return exit_code::kFailure;
  }
  StudyDesk& desk = **opened;
  AnchorQuestionOptions question = arguments.question;
  int closures = 0;
  desk.begin("anatomy 1 of " + std::to_string(question.anatomies));
  question.progress = [&](int done, int planned) {
    desk.begin("anatomy " + std::to_string(done + 1) + " of " + std::to_string(planned));
  };
  const std::vector<ScannedAnatomy> scan = scan_anchors(
      porcine_thesis_tables(),
      [&](const Valve& valve) { return desk.table(valve, ClosureOptions{}); }, question);
  const std::vector<AnchorAnswer> answers = answer_anchor_question(scan);
  int competent = 0;
  for (const ScannedAnatomy& scanned : scan) {
    if (scanned.competent) ++competent;
    closures += scanned.closures;
  }
  const std::string lead = std::to_string(competent) + " of " + std::to_string(scan.size()) +
                           " anatomies are competent when undisturbed and were asked, each by its "
                           "displacements of 6 mm along any axes that leak more than 20 mm2, " +
                           std::to_string(question.approximation.region_points) +
                           " nodes of each region; " + std::to_string(closures) +
                           " closures made now, in " + fixed(desk.seconds(), 0) + " s.";
  const std::string svg = anchor_question_svg(answers);
  const std::string page = study_page(
      "When is the trigone the better anchor?", lead,
      {{"Share of anatomies where the trigone wins",
        "50 %: the anatomy decides, not the anchor.",
        svg,
        {}},
       {"Which factor decides",
        "Of the difference trigone less saddle peak: total Sobol index of each factor, and how the "
        "difference changes from its low end to its high end. Q2 is the share of the variance that "
        "is predicted for anatomies left out; below 0.5 the indices say little.",
        "", answer_table(answers)}});
  for (const auto& [name, content] :
       {std::pair<std::string, std::string>{"scan.csv", anchor_scan_csv(scan)},
        {"answers.csv", anchor_answers_csv(answers)},
        {"anchors.svg", svg},
        {"index.html", page}})
    if (const int error = desk.write(name, content)) return error;
  for (const AnchorAnswer& a : answers)
    std::cout << to_string(a.protocol) << ", " << to_string(a.displaced) << ", "
              << to_string(a.objective) << ": trigone wins in " << a.trigone_wins << " of "
              << a.anatomies << " (" << a.ties << " ties)\n";
  std::cout << lead << "\nWritten to " << arguments.directory << "/index.html\n";
  return exit_code::kOk;
}

}  // namespace

void add_anchor_question(CLI::App& parent, int& status) {
  const auto arguments = std::make_shared<StudyAnchorsArguments>();
  CLI::App* command = parent.add_subcommand(
      "anchors", "When is the trigone the better anchor? A scan over anatomies");
  command->add_option("-o,--output", arguments->directory, "Directory for CSV, SVG, index.html")
      ->capture_default_str();
  command->add_option("--anatomies", arguments->question.anatomies, "Of the Latin hypercube")
      ->check(number_from(1, 10000))
      ->capture_default_str();
  command->add_option("--seed", arguments->question.seed, "Of the hypercube")
      ->check(number_from(std::uint64_t{0}, std::uint64_t{1} << 62))
      ->capture_default_str();
  command
      ->add_option("--region-points", arguments->question.approximation.region_points,
                   "Of the region of interest's 1,089")
      ->check(number_from(17, 1089))
      ->capture_default_str();
  command->add_option("--threads", arguments->threads, "0: all cores; does not change the answer")
      ->check(number_from(0, 1024))
      ->capture_default_str();
  command->footer(
      "Tips, trigones, saddle and leaflet reserve vary around preset porcine-thesis-tables. A few\n"
      "thousand closures an anatomy. Run again with the same directory, it goes on where it "
      "was.\n\n"
      "Example:\n"
      "  coapt study anchors --anatomies 64 -o anchors");
  command->callback([arguments, &status] { status = run(*arguments); });
}

}  // namespace coapt
