#include <functional>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "clients/cli/commands.h"
#include "clients/cli/exit_code.h"
#include "clients/cli/files.h"
#include "clients/cli/number_option.h"
#include "clients/cli/study_desk.h"
#include "io/json/findings_json.h"
#include "io/json/result_json.h"
#include "io/picture/study_charts.h"
#include "io/picture/study_csv.h"
#include "io/picture/study_page.h"
#include "io/picture/text.h"
#include "search/studies/findings_parts.h"

namespace coapt {
namespace {

struct Arguments {
  std::string valve, directory = "study";
  int threads = 0;
  bool json = false;
  std::vector<std::string> protocols;
  ThesisStudyOptions study;
};

/// What one study leaves in the directory and says.
struct Outcome {
  std::vector<std::pair<std::string, std::string>> files;  ///< name, content
  std::vector<Finding> findings;
  std::vector<PageSection> figures;
};

std::string timing(const OrificeTable& table, double seconds) {
  return std::to_string(table.configurations()) + " configurations, five end states each; " +
         std::to_string(table.closures()) + " closed now, in " + fixed(seconds, 1) + " s; " +
         std::to_string(table.untrusted()) + " not trusted (not converged, or crossed).";
}

PageSection annulus_figure(const AnnulusStudy& study) {
  return {"Annular dilation and flattening (figure 4.5)",
          "Trigones, papillary tips and transverse diameter held. Rings: the thesis's numbers.",
          annulus_svg(study, true), {}};
}

PageSection papillary_table(const PapillaryStudy& study) {
  PageSection section{"Largest orifice by class and axes (table 4.1), mm2", "", "", {{"class"}}};
  for (const char* axes : kAxesNames) section.table[0].push_back(axes);
  for (const DisplacementGrid& grid : study.grids) {
    section.table.push_back({to_string(grid.displaced)});
    for (const double area : largest_orifices(grid)) section.table.back().push_back(fixed(area, 1));
  }
  return section;
}

PageSection ring_table(const RingStudy& study) {
  PageSection section{"Largest ratio to the properly sized annulus (table 4.2), percent",
                      "Over displacements that leak 1 mm2 or more under the proper size.",
                      "",
                      {{"class", "U1", "U2", "U3"}}};
  for (const Displaced displaced : kDisplaced) {
    section.table.push_back({to_string(displaced)});
    for (int sizes = 1; sizes <= 3; ++sizes)
      section.table.back().push_back(
          fixed(100.0 * largest_ring_ratio(study, displaced, sizes), 1));
  }
  return section;
}

PageSection anchors_table(const std::vector<AnchorSummary>& summaries) {
  PageSection section{"Anchors",
                      "Means over the displaced configurations; regions of interest of 1,089 "
                      "nodes unless said otherwise. Movement and suture in mm, all else in mm2.",
                      "",
                      {{"protocol", "class", "anchor", "configurations", "repaired", "mean", "sd",
                        "sd of means", "sd by length", "sd by angles", "movement", "suture",
                        "outside the grid"}}};
  for (const AnchorSummary& s : summaries)
    section.table.push_back({to_string(s.protocol), to_string(s.displaced), s.anchor.name,
                             std::to_string(s.configurations), std::to_string(s.repaired),
                             fixed(s.mean_mm2, 2), fixed(s.sd_mm2, 2), fixed(s.sd_of_means_mm2, 2),
                             fixed(s.length_sd_mm2, 2), fixed(s.angle_sd_mm2, 2),
                             fixed(s.movement_mm, 1), fixed(s.suture_mm, 1),
                             fixed(100.0 * s.clamped_share, 0) + " %"});
  return section;
}

void add(Outcome& outcome, const AnnulusStudy& study) {
  outcome.files.emplace_back("annulus.csv", annulus_csv(study));
  outcome.files.emplace_back("annulus.svg", annulus_svg(study, true));
  outcome.figures.push_back(annulus_figure(study));
}

void add(Outcome& outcome, const PapillaryStudy& study) {
  outcome.files.emplace_back("papillary.csv", papillary_csv(study));
  outcome.files.emplace_back("papillary.svg", papillary_svg(study));
  outcome.figures.push_back({"Papillary displacement (figures 4.6 to 4.8)",
                             "Orifice over transverse and posterior displacement, a surface for "
                             "each apical one; and its gradient.",
                             papillary_svg(study), {}});
  outcome.figures.push_back(papillary_table(study));
}

void add(Outcome& outcome, const RingStudy& study) {
  outcome.files.emplace_back("ring.csv", ring_csv(study));
  outcome.files.emplace_back("ring.svg", ring_svg(study));
  outcome.figures.push_back({"Undersized rings (figure 4.9)", "", ring_svg(study), {}});
  outcome.figures.push_back(ring_table(study));
}

void add(Outcome& outcome, const std::vector<ApproximationStudy>& studies,
         const std::vector<AnchorSummary>& scan) {
  std::vector<AnchorSummary> summaries;
  for (const ApproximationStudy& study : studies) {
    const std::string name = std::string("anchors-") + to_string(study.protocol) + ".svg";
    outcome.files.emplace_back(name, anchors_histogram_svg(study));
    outcome.figures.push_back(
        {std::string("Trigone against saddle peak (figure 4.10), protocol ") +
             to_string(study.protocol),
         "", anchors_histogram_svg(study), {}});
    for (const AnchorSummary& summary : summarise(study)) summaries.push_back(summary);
  }
  outcome.files.emplace_back("approximation.csv", approximation_csv(studies));
  outcome.files.emplace_back("anchors.csv", anchors_csv(summaries));
  outcome.figures.push_back(anchors_table(summaries));
  if (scan.empty()) return;
  std::vector<AnchorSummary> same;
  for (const AnchorSummary& summary : summaries)
    if (summary.protocol == scan.front().protocol) same.push_back(summary);
  outcome.files.emplace_back("anchor-scan.csv", anchors_csv(scan));
  outcome.files.emplace_back("anchor-scan.svg", anchor_scan_svg(scan, same));
  outcome.figures.push_back({"Anchors around the annulus", "", anchor_scan_svg(scan, same), {}});
}

int finish(const Arguments& arguments, const StudyDesk& desk, const OrificeTable& table,
           Outcome outcome) {
  const std::string timed = timing(table, desk.seconds());
  outcome.files.emplace_back("findings.json", to_json(outcome.findings).dump(2) + "\n");
  outcome.files.emplace_back(
      "index.html",
      findings_page(table.valve().name, outcome.findings, outcome.figures, timed));
  for (const auto& [name, content] : outcome.files)
    if (const int error = desk.write(name, content)) return error;
  int agree = 0;
  for (const Finding& finding : outcome.findings) agree += finding.agrees ? 1 : 0;
  if (arguments.json) {
    const nlohmann::ordered_json answer = {{"valve", table.valve().name},
                                           {"configurations", table.configurations()},
                                           {"closures", table.closures()},
                                           {"untrusted", table.untrusted()},
                                           {"seconds", desk.seconds()},
                                           {"findings", outcome.findings.size()},
                                           {"agree", agree},
                                           {"notice", kResearchNotice}};
    std::cout << answer.dump(2) << '\n';
    return exit_code::kOk;
  }
  for (const Finding& finding : outcome.findings)
    std::cout << (finding.agrees ? "agrees   " : "DIFFERS  ") << finding.finding << ": "
              << finding.ours << '\n';
  std::cout << agree << " of " << outcome.findings.size() << " findings agree. " << timed
            << "\nWritten to " << arguments.directory << "/index.html\n";
  return exit_code::kOk;
}

using Study = std::function<Outcome(OrificeTable&, const ThesisStudyOptions&)>;

int run(Arguments arguments, const Study& study) {
  const Expected<Valve> valve = read_valve_argument(arguments.valve);
  if (!valve) return report_errors(arguments.valve, valve.errors());
  const Expected<std::unique_ptr<StudyDesk>> desk =
      StudyDesk::open(arguments.directory, arguments.threads);
  if (!desk) {
    report_errors("study", desk.errors());
    return exit_code::kFailure;
  }
  if (!arguments.protocols.empty()) arguments.study.protocols.clear();
  for (const Protocol protocol : kProtocols)
    for (const std::string& name : arguments.protocols)
      if (name == to_string(protocol)) arguments.study.protocols.push_back(protocol);
  arguments.study.stage = [&](const std::string& stage) { (*desk)->begin(stage); };
  OrificeTable table = (*desk)->table(*valve);
  return finish(arguments, **desk, table, study(table, arguments.study));
}

Outcome study_one_annulus(OrificeTable& table, const ThesisStudyOptions&) {
  const AnnulusStudy study = study_annulus(table);
  Outcome outcome;
  outcome.findings = annulus_findings(study);
  add(outcome, study);
  return outcome;
}

Outcome study_one_papillary(OrificeTable& table, const ThesisStudyOptions& options) {
  const PapillaryStudy study = study_papillary(table, options.papillary_nodes);
  Outcome outcome;
  outcome.findings = papillary_findings(study);
  add(outcome, study);
  return outcome;
}

Outcome study_one_ring(OrificeTable& table, const ThesisStudyOptions&) {
  const RingStudy study = study_ring(table);
  Outcome outcome;
  outcome.findings = ring_findings(study);
  add(outcome, study);
  return outcome;
}

Outcome study_approximations(OrificeTable& table, const ThesisStudyOptions& options) {
  const auto [studies, scan] = study_anchors(table, options);
  Outcome outcome;
  for (const ApproximationStudy& study : studies)
    for (const Finding& finding : anchor_findings(study)) outcome.findings.push_back(finding);
  add(outcome, studies, scan);
  return outcome;
}

Outcome study_all(OrificeTable& table, const ThesisStudyOptions& options) {
  const ThesisStudy study = study_thesis(table, options);
  Outcome outcome;
  outcome.findings = findings(study);
  add(outcome, study.annulus);
  add(outcome, study.papillary);
  add(outcome, study.ring);
  add(outcome, study.anchors.approximation, study.anchors.scan);
  return outcome;
}

CLI::App* add_one(CLI::App& parent, int& status, const char* name, const char* help,
                  const Study& study, const std::shared_ptr<Arguments>& arguments) {
  CLI::App* command = parent.add_subcommand(name, help);
  command->add_option("valve", arguments->valve, kValveHelp)->required();
  command
      ->add_option("-o,--output", arguments->directory,
                   "Directory for CSV, SVG, findings.json, index.html and the closures")
      ->capture_default_str();
  command->add_option("--threads", arguments->threads, "0: all cores; does not change the answer")
      ->check(number_from(0, 1024))
      ->capture_default_str();
  command->add_flag("--json", arguments->json, "A summary as JSON on standard output");
  command->callback([=, &status] { status = run(*arguments, study); });
  return command;
}

void add_anchor_options(CLI::App& command, const std::shared_ptr<Arguments>& arguments) {
  std::vector<std::string> names;
  for (const Protocol protocol : kProtocols) names.emplace_back(to_string(protocol));
  ThesisStudyOptions& study = arguments->study;
  command
      .add_option("--protocol", arguments->protocols,
                  "How positions get their orifice (default: both lookups)")
      ->check(CLI::IsMember(names));
  command
      .add_option("--displacement-step", study.approximation.displacement_step_mm,
                  "Of the displaced configurations, mm")
      ->check(CLI::IsMember({1.0, 2.0, 3.0, 6.0}))
      ->capture_default_str();
  command
      .add_option("--region-points", study.approximation.region_points,
                  "Of the region of interest's 1,089")
      ->check(number_from(17, 1089))
      ->capture_default_str();
  command
      .add_option("--scan-sites", study.scan_sites,
                  "Anchors around the annulus, besides trigone and saddle peak")
      ->check(number_from(0, 360))
      ->capture_default_str();
}

constexpr const char* kResumes =
    "A study that was stopped, run again with the same directory, goes on where it was.\n\n";

}  // namespace

void add_study(CLI::App& parent, int& status) {
  CLI::App* study = parent.add_subcommand(
      "study", "Redo the thesis's robustness studies on a valve, or ask further");
  study->require_subcommand(1);
  const auto with = [] { return std::make_shared<Arguments>(); };
  add_one(*study, status, "annulus",
          "Anteroposterior dilation 0 to 30 % x annular height (figure 4.5)", study_one_annulus,
          with());
  add_one(*study, status, "papillary",
          "Papillary displacement 0 to 6 mm along three axes (figures 4.6 to 4.8, table 4.1)",
          study_one_papillary, with());
  add_one(*study, status, "ring", "Undersized rings x displacement (figure 4.9, table 4.2)",
          study_one_ring, with());
  const auto approximation = with();
  CLI::App* anchors =
      add_one(*study, status, "approximation",
              "Papillary approximation to trigone, saddle peak and around the annulus (figure 4.10)",
              study_approximations, approximation);
  add_anchor_options(*anchors, approximation);
  anchors->footer(std::string(kResumes) +
                  "Examples:\n"
                  "  coapt study approximation porcine-thesis -o anchors\n"
                  "  coapt study approximation porcine-thesis --protocol closed optimum "
                  "--displacement-step 2 -o anchors");
  const auto everything = with();
  CLI::App* thesis =
      add_one(*study, status, "thesis",
              "All of them, each finding of the thesis beside this valve's", study_all, everything);
  add_anchor_options(*thesis, everything);
  thesis->footer(std::string(kResumes) +
                 "Example:\n"
                 "  coapt study thesis porcine-thesis -o thesis --threads 2 --json");
  add_calibrate(*study, status);
  add_anchor_question(*study, status);
  add_generality(*study, status);
}

}  // namespace coapt
