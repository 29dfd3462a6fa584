#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "clients/cli/commands.h"
#include "clients/cli/exit_code.h"
#include "clients/cli/files.h"
#include "clients/cli/number_option.h"
#include "clients/cli/study_desk.h"
#include "io/picture/study_report.h"

namespace coapt {
namespace {

struct Arguments {
  StudyKind kind = StudyKind::Thesis;
  std::string valve, directory;
  int threads = 0;
  bool json = false;
  std::vector<std::string> protocols;
  ThesisStudyOptions options;
};

int finish(const Arguments& arguments, const StudyDesk& desk, const OrificeTable& table,
           StudyReport report) {
  const nlohmann::ordered_json answer = complete(report, arguments.kind, table, desk.seconds());
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
  std::cout << answer["agree"] << " of " << report.findings.size() << " findings agree. "
            << study_timing(table, desk.seconds()) << "\nWritten to " << arguments.directory
            << "/index.html\n";
  return exit_code::kOk;
}

int run(Arguments arguments) {
  const Expected<Valve> valve = read_valve_argument(arguments.valve);
  if (!valve) return report_errors(arguments.valve, valve.errors());
  const Expected<std::unique_ptr<StudyDesk>> desk =
      StudyDesk::open(arguments.directory, arguments.threads);
  if (!desk) {
    report_errors("study", desk.errors());
    return exit_code::kFailure;
  }
  if (!arguments.protocols.empty()) arguments.options.protocols.clear();
  for (const Protocol protocol : kProtocols)
    for (const std::string& name : arguments.protocols)
      if (name == to_string(protocol)) arguments.options.protocols.push_back(protocol);
  arguments.options.stage = [&](const std::string& stage) { (*desk)->begin(stage); };
  OrificeTable table = (*desk)->table(*valve);
  return finish(arguments, **desk, table, run_study(arguments.kind, table, arguments.options));
}

CLI::App* add_one(CLI::App& parent, int& status, StudyKind kind, const char* help,
                  const std::shared_ptr<Arguments>& arguments) {
  CLI::App* command = parent.add_subcommand(to_string(kind), help);
  arguments->kind = kind;
  arguments->options = default_options(kind);
  arguments->directory = std::string("study-") + to_string(kind);
  command->add_option("valve", arguments->valve, kValveHelp)->required();
  command
      ->add_option("-o,--output", arguments->directory,
                   "Directory for CSV, SVG, findings.json, index.html and the closures")
      ->capture_default_str();
  command->add_option("--threads", arguments->threads, "0: all cores; does not change the answer")
      ->check(number_from(0, 1024))
      ->capture_default_str();
  command->add_flag("--json", arguments->json, "A summary as JSON on standard output");
  command->callback([=, &status] { status = run(*arguments); });
  return command;
}

void add_anchor_options(CLI::App& command, const std::shared_ptr<Arguments>& arguments) {
  std::vector<std::string> names;
  for (const Protocol protocol : kProtocols) names.emplace_back(to_string(protocol));
  ThesisStudyOptions& study = arguments->options;
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
  add_one(*study, status, StudyKind::Annulus,
          "Anteroposterior dilation 0 to 30 % x annular height (figure 4.5)", with());
  add_one(*study, status, StudyKind::Papillary,
          "Papillary displacement 0 to 6 mm along three axes (figures 4.6 to 4.8, table 4.1)",
          with());
  add_one(*study, status, StudyKind::Ring,
          "Undersized rings x displacement (figure 4.9, table 4.2)", with());
  const auto approximation = with();
  CLI::App* anchors = add_one(
      *study, status, StudyKind::Approximation,
      "Papillary approximation to trigone, saddle peak and around the annulus (figure 4.10)",
      approximation);
  add_anchor_options(*anchors, approximation);
  anchors->footer(std::string(kResumes) +
                  "Examples:\n"
                  "  coapt study approximation porcine-thesis -o anchors\n"
                  "  coapt study approximation porcine-thesis --protocol closed optimum "
                  "--displacement-step 2 -o anchors");
  const auto everything = with();
  CLI::App* thesis =
      add_one(*study, status, StudyKind::Thesis,
              "All of them, each finding of the thesis beside this valve's", everything);
  add_anchor_options(*thesis, everything);
  thesis->footer(std::string(kResumes) +
                 "Example:\n"
                 "  coapt study thesis porcine-thesis -o thesis --threads 2 --json");
  add_calibrate(*study, status);
  add_anchor_question(*study, status);
  add_generality(*study, status);
}

}  // namespace coapt
