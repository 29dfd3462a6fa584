#include <algorithm>
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
#include "clients/cli/study_report.h"
#include "io/json/findings_json.h"
#include "io/json/result_json.h"
#include "io/picture/text.h"
#include "search/studies/findings_parts.h"
#include "search/studies/thesis_figures.h"

namespace coapt {
namespace {

struct Arguments {
  std::string name, valve, directory;
  int threads = 0;
  bool json = false;
  std::vector<std::string> protocols;
  ThesisStudyOptions study;
};

std::string timing(const OrificeTable& table, double seconds) {
  return std::to_string(table.configurations()) + " configurations, five end states each; " +
         std::to_string(table.closures()) + " closed now, in " + fixed(seconds, 1) + " s; " +
         std::to_string(table.untrusted()) +
         " not trusted (not converged, or crossed). The thesis: " +
         std::to_string(thesis::kConfigurations) + " in about " + fixed(thesis::kHours, 0) +
         " hours.";
}

int finish(const Arguments& arguments, const StudyDesk& desk, const OrificeTable& table,
           StudyReport report) {
  const std::string timed = timing(table, desk.seconds());
  const auto agree = std::count_if(report.findings.begin(), report.findings.end(),
                                   [](const Finding& finding) { return finding.agrees; });
  const nlohmann::ordered_json answer = {{"study", arguments.name},
                                         {"valve", table.valve().name},
                                         {"version", version()},
                                         {"configurations", table.configurations()},
                                         {"closures", table.closures()},
                                         {"untrusted", table.untrusted()},
                                         {"seconds", desk.seconds()},
                                         {"findings", report.findings.size()},
                                         {"agree", agree},
                                         {"notice", kResearchNotice}};
  report.files.emplace_back("study.json", answer.dump(2) + "\n");
  report.files.emplace_back("findings.json", to_json(report.findings).dump(2) + "\n");
  report.files.emplace_back(
      "index.html", findings_page(table.valve().name, report.findings, report.figures, timed));
  for (const auto& [name, content] : report.files)
    if (const int error = desk.write(name, content)) return error;
  if (arguments.json) {
    std::cout << answer.dump(2) << '\n';
    return exit_code::kOk;
  }
  if (report.findings.empty()) std::cout << "No displacement leaks enough to be repaired.\n";
  for (const Finding& finding : report.findings)
    std::cout << (finding.agrees ? "agrees   " : "DIFFERS  ") << finding.finding << ": "
              << finding.ours << '\n';
  std::cout << agree << " of " << report.findings.size() << " findings agree. " << timed
            << "\nWritten to " << arguments.directory << "/index.html\n";
  return exit_code::kOk;
}

using Study = std::function<StudyReport(OrificeTable&, const ThesisStudyOptions&)>;

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

StudyReport study_one_annulus(OrificeTable& table, const ThesisStudyOptions&) {
  const AnnulusStudy study = study_annulus(table);
  StudyReport report;
  report.findings = annulus_findings(study);
  add_to_report(report, study);
  return report;
}

StudyReport study_one_papillary(OrificeTable& table, const ThesisStudyOptions& options) {
  const PapillaryStudy study = study_papillary(table, options.papillary_nodes);
  StudyReport report;
  report.findings = papillary_findings(study);
  add_to_report(report, study);
  return report;
}

StudyReport study_one_ring(OrificeTable& table, const ThesisStudyOptions&) {
  const RingStudy study = study_ring(table);
  StudyReport report;
  report.findings = ring_findings(study);
  add_to_report(report, study);
  return report;
}

StudyReport study_approximations(OrificeTable& table, const ThesisStudyOptions& options) {
  const AnchorStudies studies = study_anchors(table, options);
  StudyReport report;
  for (const ApproximationStudy& study : studies.approximation)
    for (const Finding& finding : anchor_findings(study)) report.findings.push_back(finding);
  add_to_report(report, studies);
  return report;
}

StudyReport study_all(OrificeTable& table, const ThesisStudyOptions& options) {
  const ThesisStudy study = study_thesis(table, options);
  StudyReport report;
  report.findings = findings(study);
  add_to_report(report, study.annulus);
  add_to_report(report, study.papillary);
  add_to_report(report, study.ring);
  add_to_report(report, study.anchors);
  return report;
}

CLI::App* add_one(CLI::App& parent, int& status, const char* name, const char* help,
                  const Study& study, const std::shared_ptr<Arguments>& arguments) {
  CLI::App* command = parent.add_subcommand(name, help);
  arguments->name = name;
  arguments->directory = std::string("study-") + name;
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
  CLI::App* anchors = add_one(
      *study, status, "approximation",
      "Papillary approximation to trigone, saddle peak and around the annulus (figure 4.10)",
      study_approximations, approximation);
  add_anchor_options(*anchors, approximation);
  anchors->footer(std::string(kResumes) +
                  "Examples:\n"
                  "  coapt study approximation porcine-thesis -o anchors\n"
                  "  coapt study approximation porcine-thesis --protocol closed optimum "
                  "--displacement-step 2 -o anchors");
  const auto everything = with();
  everything->study.scan_sites = 0;  // the thesis has none
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
