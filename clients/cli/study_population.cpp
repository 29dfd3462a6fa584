#include <algorithm>
#include <chrono>
#include <iostream>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "clients/cli/commands.h"
#include "clients/cli/exit_code.h"
#include "clients/cli/files.h"
#include "clients/cli/interrupt.h"
#include "clients/cli/population_directory.h"
#include "clients/cli/progress_bar.h"
#include "io/command_line/command_line.h"
#include "io/json/population_json.h"
#include "io/json/result_json.h"
#include "io/picture/text.h"
#include "io/store/record_file.h"
#include "io/store/subject.h"
#include "search/population/population_records.h"

namespace coapt {
namespace {

struct StudyPopulationArguments {
  std::string population, directory = "study-population";
  int members = 0, searched = 12, evaluations = 300;
  PopulationRecordOptions records;
  bool json = false;
};

constexpr int kMembersAtOnce = 16;  // what a killed study loses at most

/// All that decides the records of a population.
std::string records_id(const Population& population, const PopulationRecordOptions& options) {
  return fnv1a_128(to_json(population).dump() + " nodes " + std::to_string(options.nodes));
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
  const Expected<std::vector<PopulationRecord>> records =
      kept_records(arguments, *population, count);
  if (!records) {
    report_errors("study population", records.errors());
    return exit_code::kFailure;
  }
  return exit_code::kOk;
}

}  // namespace

void add_study_population(Command parent, int& status) {
  const auto arguments = std::make_shared<StudyPopulationArguments>();
  Command command = parent.add_command(
      "population", "Which repair suits which valve of a population, and a tree that tells");
  command.add_option("population", arguments->population, "Directory of population make")
      .required();
  command.add_option("--members", arguments->members, "Only the first ones; 0: all")
      .check(number_from(0, 100000))
      .show_default();
  command
      .add_option("--nodes", arguments->records.nodes,
                  "Closures of each repair: as planned and disturbed")
      .check(number_from(1, 1089))
      .show_default();
  command
      .add_option("--searched", arguments->searched,
                  "Held-out valves on which the tree is compared with the full search")
      .check(number_from(0, 10000))
      .show_default();
  command.add_option("--evaluations", arguments->evaluations, "Closures of each of these searches")
      .check(number_from(50, 1000000))
      .show_default();
  command.add_option("-o,--output", arguments->directory, "Directory for JSON, CSV and index.html")
      .show_default();
  command
      .add_option("--threads", arguments->records.threads,
                  "0: all cores; does not change the answer")
      .check(number_from(0, 1024))
      .show_default();
  command.add_flag("--json", arguments->json, "Print the findings");
  command.footer(
      "Each valve is closed after up to 34 repairs, each as planned and disturbed. What is closed "
      "is kept\nin records.bin: a study that was interrupted goes on.\n\n"
      "Example:\n"
      "  coapt population make -n 200 -o adults && coapt study population adults -o repairs");
  command.on_run([arguments, &status] { status = run(*arguments); });
}

}  // namespace coapt
