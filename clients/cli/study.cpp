#include <filesystem>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "clients/cli/ask.h"
#include "clients/cli/commands.h"
#include "clients/cli/farm_option.h"
#include "clients/cli/read_argument.h"
#include "clients/cli/run_options.h"
#include "clients/cli/server_option.h"
#include "clients/cli/service_job.h"
#include "clients/cli/study_directory.h"
#include "core/valve/printable.h"
#include "io/command_line/command_line.h"
#include "io/command_line/exit_code.h"
#include "io/command_line/files.h"
#include "io/command_line/interrupt.h"
#include "io/json/findings_json.h"
#include "io/picture/study_report.h"

namespace coapt {
namespace {

struct StudyArguments {
  StudyKind kind = StudyKind::Thesis;
  std::string valve, directory, farm;
  int threads = 0;
  bool json = false;
  std::vector<std::string> protocols;
  ThesisStudyOptions options;
  ServerOption server;
};

/// Prints a study's summary (study.json) and its findings; returns an exit code.
int show(const StudyArguments& arguments, const Json& study, const Json& findings) {
  if (arguments.json) {
    std::cout << json_text(study, 2) << '\n';
    return exit_code::kOk;
  }
  if (findings.empty()) std::cout << "No displacement causes a leak large enough to repair.\n";
  for (const Json& finding : findings)
    std::cout << (finding["agrees"].get<bool>() ? "agrees   " : "DIFFERS  ")
              << finding["finding"].get<std::string>() << ": " << finding["ours"].get<std::string>()
              << '\n';
  std::cout << study["agree"] << " of " << findings.size() << " findings agree. "
            << study_timing(study) << "\nWritten to " << printable(arguments.directory)
            << "/index.html\n";
  return exit_code::kOk;
}

int finish(const StudyArguments& arguments, const StudyDirectory& directory, OrificeTable& table,
           StudyReport report) {
  const Json answer = complete(report, arguments.kind, table, directory.seconds());
  for (const auto& [name, content] : report.files)
    if (const int error = directory.write(name, content)) return error;
  return show(arguments, answer, to_json(report.findings));
}

/// The protocols of --protocol in place of the default, in their order.
void choose_protocols(StudyArguments& arguments) {
  if (arguments.protocols.empty()) return;
  arguments.options.protocols.clear();
  for (const Protocol protocol : kProtocols)
    for (const std::string& name : arguments.protocols)
      if (name == to_string(protocol)) arguments.options.protocols.push_back(protocol);
}

Json request_of(const StudyArguments& arguments) {
  const ThesisStudyOptions& options = arguments.options;
  Json study = {{"name", to_string(arguments.kind)}};
  if (arguments.kind != StudyKind::Approximation && arguments.kind != StudyKind::Thesis)
    return study;
  for (const Protocol protocol : options.protocols)
    study["protocols"].push_back(to_string(protocol));
  study["displacement_step_mm"] = options.approximation.displacement_step_mm;
  study["region_points"] = options.approximation.region_points;
  study["scan_sites"] = options.scan_sites;
  return study;
}

/// Puts the files that a job has left into the directory. Returns an exit code.
int fetch_files(const Service& service, const ServiceJob& job, const std::string& directory) {
  namespace fs = std::filesystem;
  const Expected<Json> listed = get_json(service, job.path + "/files");
  if (!listed) return report_refusal("study", listed.errors(), {});
  for (const Json& file : listed->at("files")) {
    const std::string name = file.at("name").get<std::string>();
    const Expected<std::string> content = get(service, job.path + "/files/" + name);
    if (!content) return report_refusal("study", content.errors(), {});
    if (const int failed = write_output((fs::path(directory) / name).string(), *content))
      return failed;
  }
  return exit_code::kOk;
}

int run_by(const Service& service, StudyArguments arguments) {
  const std::atomic<bool>& interrupted = catch_interrupts();
  const Expected<Json> valve = valve_to_send(arguments.valve);
  if (!valve) return report_errors(arguments.valve, valve.errors());
  if (const Errors errors = make_directory(arguments.directory); !errors.empty()) {
    report_errors("study", errors);
    return exit_code::kFailure;
  }
  choose_protocols(arguments);
  const Json request = {{"valve", *valve}, {"study", request_of(arguments)}};
  const Expected<ServiceJob> job = run_job(service, "/v1/studies", request, interrupted);
  if (!job) return report_refusal("study", job.errors(), {{"/valve", arguments.valve}});
  if (job->state == "CANCELLED") {
    std::cerr << "coapt: study: cancelled; the service stores the closures, so repeat the request "
                 "to continue\n";
    return exit_code::kInterrupted;
  }
  Expected<Json> study = get_json(service, job->path + "/result");
  if (!study) return report_refusal("study", study.errors(), {});
  if (const int failed = fetch_files(service, *job, arguments.directory)) return failed;
  const Json findings = (*study)["findings"];
  (*study)["findings"] = findings.size();
  return show(arguments, *study, findings);
}

int run(StudyArguments arguments) {
  const Expected<Valve> valve = read_valve_argument(arguments.valve);
  if (!valve) return report_errors(arguments.valve, valve.errors());
  const Expected<std::unique_ptr<StudyDirectory>> directory = StudyDirectory::open(
      arguments.directory,
      {arguments.threads, arguments.farm, std::string("coapt study ") + to_string(arguments.kind)});
  if (!directory) {
    report_errors("study", directory.errors());
    return exit_code::kFailure;
  }
  choose_protocols(arguments);
  arguments.options.stage = [&](const std::string& stage) { (*directory)->begin(stage); };
  OrificeTable table = (*directory)->table(*valve);
  return finish(arguments, **directory, table, run_study(arguments.kind, table, arguments.options));
}

constexpr const char* kResumes =
    "An interrupted study resumes when run again with the same directory.\n\n";

Command add_one(Command parent, int& status, StudyKind kind, const char* help,
                const std::shared_ptr<StudyArguments>& arguments) {
  Command command = parent.add_command(to_string(kind), help);
  arguments->kind = kind;
  arguments->options = default_options(kind);
  arguments->directory = std::string("study-") + to_string(kind);
  command.add_option("valve", arguments->valve, kValveHelp).required();
  command
      .add_option("-o,--output", arguments->directory,
                  "Directory for CSV, SVG, findings.json, index.html and the closures")
      .show_default();
  add_threads_option(command, arguments->threads);
  command.add_flag("--json", arguments->json, "Print a summary as JSON");
  add_farm_option(command, arguments->farm, "Compute the closures");
  add_server_option(command, arguments->server);
  const std::string name = to_string(kind);
  command.footer(kResumes + ("Example:\n  coapt study " + name + " porcine-thesis -o " + name));
  command.on_run([=, &status] {
    const auto service = service_of(command, arguments->server, {"--threads", "--farm"});
    if (!service) {
      status = report_errors("study", service.errors());
    } else {
      status = *service ? run_by(**service, *arguments) : run(*arguments);
    }
  });
  return command;
}

void add_anchor_options(Command command, const std::shared_ptr<StudyArguments>& arguments) {
  std::vector<std::string> names;
  for (const Protocol protocol : kProtocols) names.emplace_back(to_string(protocol));
  ThesisStudyOptions& study = arguments->options;
  command
      .add_option("--protocol", arguments->protocols,
                  "Method that determines the orifice at a position (default: both lookups)")
      .one_of(names);
  command
      .add_option("--displacement-step", study.approximation.displacement_step_mm,
                  "Step of the displacements, mm")
      .one_of({1.0, 2.0, 3.0, 6.0})
      .show_default();
  command
      .add_option("--region-points", study.approximation.region_points,
                  "Number of points of the region of interest to close, out of 1,089")
      .check(number_from(17, 1089))
      .show_default();
  command
      .add_option("--scan-sites", study.scan_sites,
                  "Number of anchors around the annulus, in addition to trigone and saddle peak")
      .check(number_from(0, 360))
      .show_default();
}

}  // namespace

void add_study(Command parent, int& status) {
  Command study = parent.add_command(
      "study", "Run the robustness studies of the thesis, and further studies, on a valve");
  study.require_command();
  const auto with = [] { return std::make_shared<StudyArguments>(); };
  add_one(study, status, StudyKind::Annulus,
          "Vary anteroposterior dilation (0 to 30 %) and annular height (figure 4.5)", with());
  add_one(
      study, status, StudyKind::Papillary,
      "Displace the papillary tips by 0 to 6 mm along three axes (figures 4.6 to 4.8, table 4.1)",
      with());
  add_one(study, status, StudyKind::Ring,
          "Combine undersized rings with papillary displacement (figure 4.9, table 4.2)", with());
  const auto approximation = with();
  Command anchors = add_one(
      study, status, StudyKind::Approximation,
      "Approximate the papillary tips to trigone, saddle peak and around the annulus (figure 4.10)",
      approximation);
  add_anchor_options(anchors, approximation);
  anchors.footer(std::string(kResumes) +
                 "Examples:\n"
                 "  coapt study approximation porcine-thesis -o anchors\n"
                 "  coapt study approximation porcine-thesis --protocol closed optimum "
                 "--displacement-step 2 -o anchors");
  const auto everything = with();
  Command thesis =
      add_one(study, status, StudyKind::Thesis,
              "Run these four studies and compare each finding of the thesis with this valve's",
              everything);
  add_anchor_options(thesis, everything);
  thesis.footer(
      std::string(kResumes) +
      "Examples:\n"
      "  coapt study thesis porcine-thesis -o thesis --threads 2 --json\n"
      "  coapt study thesis porcine-thesis -o thesis --farm postgresql://farm.example/coapt\n"
      "  coapt study thesis porcine-thesis -o thesis --server http://127.0.0.1:8080");
  add_calibrate(study, status);
  add_anchor_question(study, status);
  add_generality(study, status);
  add_study_imports(study, status);
  add_study_information(study, status);
  add_study_model(study, status);
  add_study_physiology(study, status);
  add_study_population(study, status);
}

}  // namespace coapt
