#include <algorithm>
#include <chrono>
#include <iostream>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "clients/cli/commands.h"
#include "clients/cli/farm_option.h"
#include "clients/cli/population_directory.h"
#include "clients/cli/run_options.h"
#include "farm/work/population_work.h"
#include "io/command_line/command_line.h"
#include "io/command_line/exit_code.h"
#include "io/command_line/files.h"
#include "io/command_line/interrupt.h"
#include "io/command_line/progress_bar.h"
#include "io/json/population_json.h"
#include "io/json/population_study_json.h"
#include "io/json/subject.h"
#include "io/picture/population_page.h"
#include "io/picture/population_study_csv.h"
#include "io/picture/population_study_page.h"
#include "io/picture/text.h"
#include "io/picture/tree_picture.h"
#include "io/store/record_file.h"
#include "search/population/population_study.h"

namespace coapt {
namespace {

struct StudyPopulationArguments {
  std::string population, farm, directory = "study-population";
  int members = 0, searched = 12, evaluations = 300;
  PopulationRecordOptions records;
  bool json = false;
};

constexpr int kMembersAtOnce = 16;  // what a killed study loses at most

/// All that decides the records of a population.
std::string records_id(const Population& population, const PopulationRecordOptions& options) {
  std::string all = to_json(population).dump() + " nodes " + std::to_string(options.nodes);
  for (const CandidateRepair& candidate : candidate_repairs()) all += "; " + candidate.name;
  return fnv1a_128(all);
}

/// All records, by a farm.
Expected<std::string> asked_records(const StudyPopulationArguments& arguments,
                                    const Population& population, int count) {
  const Expected<WorkRequest> request = records_request(population, count, arguments.records);
  if (!request) return request.errors();
  const ProgressBar bar;
  AskContext context{.label = "study population " + arguments.directory,
                     .cancelled = arguments.records.cancelled};
  context.progress = [&](const AskProgress& now) { bar.show(now.done, now.items, "valves"); };
  return asker_of(arguments.farm, arguments.records.threads)(*request, context);
}

/// Records of the first `count` members, those that a file has among them.
Expected<std::vector<PopulationRecord>> kept_records(const StudyPopulationArguments& arguments,
                                                     const Population& population, int count) {
  Expected<RecordFile> file =
      RecordFile::open(arguments.directory + "/records.bin",
                       records_id(population, arguments.records), sizeof(PopulationRecord));
  if (!file) return file.errors();
  std::string bytes = file->records();
  const auto done = [&] { return static_cast<int>(bytes.size() / sizeof(PopulationRecord)); };
  if (!arguments.farm.empty() && done() < count) {
    const Expected<std::string> all = asked_records(arguments, population, count);
    if (!all) return all.errors();
    if (Errors errors = file->append(std::string_view(*all).substr(bytes.size())); !errors.empty())
      return errors;
    bytes = *all;
  }
  const ProgressBar bar;
  while (done() < count) {
    bar.show(done(), count, "valves");
    const std::string more = population_records(population, arguments.records, done(),
                                                std::min(kMembersAtOnce, count - done()));
    if (more.empty()) break;
    if (Errors errors = file->append(more); !errors.empty()) return errors;
    bytes += more;
  }
  bytes.resize(std::min(bytes.size(), static_cast<std::size_t>(count) * sizeof(PopulationRecord)));
  return unpack_records(bytes);
}

/// Compares the tree with the full search on some of the valves that it is judged on.
void search_held_out(const StudyPopulationArguments& arguments, const Population& population,
                     const std::vector<PopulationRecord>& records, PopulationStudy& study) {
  if (!study.tree) return;
  const std::vector<int> held_out = members_to_search(records, arguments.searched);
  const ProgressBar bar;
  for (const int index : held_out) {
    bar.show(static_cast<int>(study.searched.size()), static_cast<int>(held_out.size()),
             "searches");
    const auto at = static_cast<std::size_t>(index);
    const Expected<SearchedMember> searched =
        search_member(population.members[at], records[at], study.tree->tree, arguments.evaluations,
                      arguments.records);
    if (*arguments.records.cancelled) return;
    if (searched) study.searched.push_back(*searched);
  }
}

std::string lead_of(const PopulationStudy& study, const Population& population) {
  return counted(study.members, "valve") + " of the prior \"" + population.prior.name +
         "\" (seed " + std::to_string(population.seed) + "), " + std::to_string(study.not_made) +
         " not made; " + grouped(study.closures) + ' ' + noun_of(study.closures, "closure") +
         " of repairs, " + grouped(study.failures) + " not reliable. " +
         assumed_words(population.prior) +
         " All results are model predictions on sampled valves, not a clinical trial.";
}

/// Name and content.
std::vector<std::pair<std::string, std::string>> files_of(
    const PopulationStudy& study, const std::vector<PopulationRecord>& records,
    const std::string& json, const std::string& lead) {
  std::vector<std::pair<std::string, std::string>> files = {
      {"records.csv", population_records_csv(records)},
      {"findings.csv", population_findings_csv(study)},
      {"findings.json", json},
      {"index.html", population_study_page(study, lead)}};
  if (study.tree) {
    std::string words;
    for (const std::string& line : tree_in_words(study.tree->tree)) words += line + '\n';
    files.emplace_back("tree.json", to_json(*study.tree).dump(2) + "\n");
    files.emplace_back("tree.svg", tree_svg(*study.tree));
    files.emplace_back("tree.txt", words);
  }
  return files;
}

int run(StudyPopulationArguments arguments) {
  const std::atomic<bool>& interrupted = catch_interrupts();
  arguments.records.cancelled = &interrupted;
  const Expected<Population> population = read_population_directory(arguments.population);
  if (!population) return report_errors(arguments.population, population.errors());
  if (const Errors errors = make_directory(arguments.directory); !errors.empty()) {
    report_errors("study population", errors);
    return exit_code::kFailure;
  }
  const int all = static_cast<int>(population->members.size());
  const int count = arguments.members > 0 ? std::min(arguments.members, all) : all;
  const auto start = std::chrono::steady_clock::now();
  const Expected<std::vector<PopulationRecord>> records =
      kept_records(arguments, *population, count);
  if (!records) {
    report_errors("study population", records.errors());
    return exit_code::kFailure;
  }
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  PopulationStudy study = study_records(*population, *records, arguments.records.nodes);
  if (!interrupted) search_held_out(arguments, *population, *records, study);
  const std::string lead = lead_of(study, *population);
  const std::string json = json_text(to_json(study), 2) + "\n";
  for (const auto& [name, content] : files_of(study, *records, json, lead))
    if (const int error = write_output(arguments.directory + "/" + name, content)) return error;
  if (arguments.json) {
    std::cout << json;
  } else {
    for (const std::string& sentence : study_sentences(study)) std::cout << sentence << '\n';
    if (study.tree)
      for (const std::string& line : tree_in_words(study.tree->tree)) std::cout << line << '\n';
    std::cout << printable(lead) << "\n"
              << fixed(seconds, 0) << " s for new closures. Written to "
              << printable(arguments.directory) << "/index.html\n";
  }
  return interrupted ? exit_code::kInterrupted : exit_code::kOk;
}

}  // namespace

void add_study_population(Command parent, int& status) {
  const auto arguments = std::make_shared<StudyPopulationArguments>();
  Command command = parent.add_command(
      "population", "Compare repairs across a population and derive a decision tree");
  command
      .add_option("population", arguments->population, "Directory written by coapt population make")
      .required();
  command
      .add_option("--members", arguments->members,
                  "Number of members to use, from the first (0: all)")
      .check(number_from(0, 100000))
      .show_default();
  command
      .add_option("--nodes", arguments->records.nodes,
                  "Number of closures of each repair: as planned and disturbed")
      .check(number_from(1, 1089))
      .show_default();
  command
      .add_option("--searched", arguments->searched,
                  "Number of held-out valves on which the tree is compared with the full search")
      .check(number_from(0, 10000))
      .show_default();
  command
      .add_option("--evaluations", arguments->evaluations,
                  "Number of closures of each of these searches")
      .check(number_from(50, 1000000))
      .show_default();
  command.add_option("-o,--output", arguments->directory, "Directory for JSON, CSV and index.html")
      .show_default();
  add_threads_option(command, arguments->records.threads);
  add_farm_option(command, arguments->farm, "Repair and close the valves");
  command.add_flag("--json", arguments->json, "Print the findings as JSON");
  command.footer(
      "Each valve is closed after up to 34 repairs, each as planned and disturbed. Closures are "
      "stored in\nrecords.bin; an interrupted study resumes from them.\n\n"
      "Example:\n"
      "  coapt population make -n 200 -o adults\n"
      "  coapt study population adults -o repairs");
  command.on_run([arguments, &status] { status = run(*arguments); });
}

}  // namespace coapt
