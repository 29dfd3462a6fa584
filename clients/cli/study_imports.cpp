// Every label map of a folder: whether it is imported, closes and is repaired with nothing touched, and what must be looked at.
#include <algorithm>
#include <cctype>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "clients/cli/commands.h"
#include "clients/cli/import_inputs.h"
#include "core/closed/closed_valve.h"
#include "core/closure/standing.h"
#include "io/command_line/command_line.h"
#include "io/command_line/exit_code.h"
#include "io/command_line/files.h"
#include "io/command_line/interrupt.h"
#include "io/command_line/progress_bar.h"
#include "io/exchange/decisions_json.h"
#include "io/json/parse_json.h"
#include "io/json/subject.h"
#include "io/json/valve_json.h"
#include "io/picture/csv_lines.h"
#include "io/picture/import_picture.h"
#include "search/plans/plan_search.h"

namespace coapt {
namespace {

namespace fs = std::filesystem;

struct StudyImportsArguments {
  std::string folder, directory = "study-imports";
  int evaluations = 0, seed = 1;
  bool pictures = false, json = false;
};

/// In this order; a map has reached the last one that it passed.
constexpr const char* kStages[] = {"refused", "imported", "closed", "planned"};

/// One import: a label map, or the files of a folder.
struct Subject {
  std::string name;
  std::vector<std::string> paths;
};

Expected<std::vector<Subject>> subjects_in(const std::string& folder) {
  std::error_code failed;
  std::vector<Subject> subjects;
  for (auto entry = fs::directory_iterator(folder, failed);
       !failed && entry != fs::directory_iterator(); entry.increment(failed)) {
    std::error_code ignored;
    Subject subject{entry->path().filename(), {}};
    if (entry->is_directory(ignored)) {
      if (const auto files = files_of(entry->path())) subject.paths = importable(*files).paths;
    } else if (entry->is_regular_file(ignored) && is_label_map_format(format_of(subject.name))) {
      subject.paths = {entry->path()};
    }
    if (!subject.paths.empty()) subjects.push_back(std::move(subject));
  }
  if (failed) return Error{ErrorCode::InputOutput, "", "cannot be opened as a folder"};
  if (subjects.empty())
    return Error{ErrorCode::MissingField, "",
                 "has no label map (.nrrd, .nii, .mha, .gz, .bz2) and no folder with files"};
  std::sort(subjects.begin(), subjects.end(),
            [](const Subject& a, const Subject& b) { return a.name < b.name; });
  return subjects;
}

Json refusal(const Errors& errors) {
  return {{"stage", "refused"},
          {"reason", errors[0].path + (errors[0].path.empty() ? "" : ": ") + errors[0].message}};
}

Expected<ImportedValve> imported(std::vector<NamedFile> files, const std::string& name, int seed) {
  ImportRequest request;
  request.files = std::move(files);
  request.reading.most_unpacked = kMostUnpacked;
  request.name = name;
  request.seed = seed;
  return make_import(std::move(request), {});
}

/// How far the import goes. Its valve and picture are written below `directory`.
Json outcome(const StudyImportsArguments& arguments, const Subject& subject,
             std::vector<NamedFile> files, const std::atomic<bool>& interrupted) {
  const Expected<ImportedValve> made = imported(std::move(files), subject.name, arguments.seed);
  if (!made) return refusal(made.errors());
  const fs::path directory = arguments.directory;
  Json row = {{"stage", "imported"}, {"reason", ""}, {"looks", Json::array()}};
  for (const ImportDecision& decision : made->decisions)
    if (decision.look) row["looks"].push_back(sentence(decision));
  row["valve"] = "valves/" + subject.name + ".json";
  if (write_output(directory / row["valve"].get<std::string>(), write_valve(made->valve)) !=
      exit_code::kOk)
    row["valve"] = nullptr;
  if (arguments.pictures)
    (void)write_output(directory / "pictures" / (subject.name + ".png"),
                       import_picture_png(*made, subject.name));
  const ClosedValve closed = close_and_measure(made->valve);
  if (!trusted(closed.closure)) {
    row["reason"] = doubt_about(closed.closure);
    return row;
  }
  row["stage"] = "closed";
  row["leak_mm2"] = closed.measure.leak.area_mm2;
  if (arguments.evaluations == 0) return row;
  SearchOptions options;
  options.evaluations = arguments.evaluations;
  options.plans = 1;
  options.evidence = false;
  options.model_draws = 0;
  options.region_points = 17;
  const Expected<SearchResult> found =
      search_plans(made->valve, options, {.cancelled = &interrupted});
  if (!found || found->plans.empty()) {
    row["reason"] = found ? "no plan was found" : found.errors()[0].message;
    return row;
  }
  row["stage"] = "planned";
  row["plan_leak_mm2"] = found->plans[0].measure.leak.area_mm2;
  return row;
}

/// What was done before, by the id of its bytes. A line that a killed study left half is not there.
std::map<std::string, Json> kept_rows(const std::string& path) {
  std::map<std::string, Json> rows;
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);)
    if (const Expected<Json> row = parse_json(line);
        row && row->is_object() && row->contains("id") && row->contains("stage"))
      rows[row->at("id").get<std::string>()] = *row;
  return rows;
}

std::string table_of(const std::vector<Json>& rows) {
  CsvLines csv("name,stage,looks,leak_mm2,plan_leak_mm2,seconds,reason,first_look");
  for (const Json& row : rows) {
    const Json looks = row.value("looks", Json::array());
    csv << row["name"].get<std::string>() << row["stage"].get<std::string>()
        << static_cast<int>(looks.size()) << row.value("leak_mm2", std::nan(""))
        << row.value("plan_leak_mm2", std::nan("")) << row.value("seconds", 0.0)
        << row.value("reason", std::string())
        << (looks.empty() ? std::string() : looks[0].get<std::string>());
    csv.end_line();
  }
  return csv.text();
}

/// What messages have in common: without their numbers.
std::string without_numbers(const std::string& reason) {
  std::string kind;
  for (const char c : reason)
    if (std::isdigit(static_cast<unsigned char>(c)) == 0)
      kind += c;
    else if (!kind.ends_with('#'))
      kind += '#';
  return kind;
}

Json summary_of(const std::vector<Json>& rows) {
  std::map<std::string, int> stages, reasons, looks;
  int unlooked = 0;
  for (const Json& row : rows) {
    ++stages[row["stage"].get<std::string>()];
    if (const std::string reason = row.value("reason", std::string()); !reason.empty())
      ++reasons[without_numbers(reason)];
    const Json said = row.value("looks", Json::array());
    for (const Json& look : said) {
      const std::string text = look.get<std::string>();
      ++looks[text.substr(0, text.find(':'))];
    }
    if (row["stage"] != "refused" && said.empty()) ++unlooked;
  }
  Json summary = result_document("coapt.imports_study/1", {{"maps", rows.size()}});
  for (const char* stage : kStages) summary["stages"][stage] = stages[stage];
  summary["nothing_to_look_at"] = unlooked;
  summary["reasons"] = reasons;
  summary["looks"] = looks;
  return summary;
}

int finish(const StudyImportsArguments& arguments, const std::vector<Json>& rows) {
  const fs::path directory = arguments.directory;
  Json summary = summary_of(rows);
  Json document = summary;
  document["imports"] = rows;
  if (const int failed = write_output(directory / "imports.csv", table_of(rows))) return failed;
  if (const int failed = write_output(directory / "imports.json", document.dump(2) + '\n'))
    return failed;
  if (arguments.json) {
    std::cout << summary.dump(2) << '\n';
    return exit_code::kOk;
  }
  for (const char* stage : kStages)
    std::cout << stage << ": " << summary["stages"][stage] << " of " << rows.size() << '\n';
  std::cout << "imported without a decision to check: " << summary["nothing_to_look_at"] << '\n';
  for (const auto& [reason, count] : summary["reasons"].items())
    std::cout << count << " x " << reason << '\n';
  std::cout << "Written to " << (directory / "imports.csv").string() << '\n';
  return exit_code::kOk;
}

int run(const StudyImportsArguments& arguments) {
  const std::atomic<bool>& interrupted = catch_interrupts();
  const Expected<std::vector<Subject>> subjects = subjects_in(arguments.folder);
  if (!subjects) return report_errors(arguments.folder, subjects.errors());
  const fs::path directory = arguments.directory;
  for (const fs::path& path : {directory / "valves", directory / "pictures"})
    if (const Errors errors = make_directory(path); !errors.empty()) {
      report_errors("study imports", errors);
      return exit_code::kFailure;
    }
  const std::string kept_path = directory / "imports.jsonl";
  std::map<std::string, Json> kept = kept_rows(kept_path);
  std::ofstream log(kept_path, std::ios::app);
  std::vector<Json> rows;
  {
    const ProgressBar bar;
    for (const Subject& subject : *subjects) {
      bar.show(std::ssize(rows), std::ssize(*subjects), "imports");
      const auto start = std::chrono::steady_clock::now();
      std::vector<NamedFile> files;
      Errors unread;
      std::string all = closures_revision() + ' ' + std::to_string(arguments.evaluations) + ' ' +
                        std::to_string(arguments.seed);
      for (const std::string& path : subject.paths) {
        Expected<NamedFile> file = read_import_file(path);
        if (!file) {
          unread = file.errors();
          break;
        }
        files.push_back(*std::move(file));
        all += '\n' + files.back().name + '\n' + fnv1a_128(files.back().bytes);
      }
      const std::string id = fnv1a_128(all);
      if (const auto found = kept.find(id); found != kept.end()) {
        rows.push_back(found->second);
        rows.back()["name"] = subject.name;
        continue;
      }
      if (interrupted) break;
      Json row = unread.empty() ? outcome(arguments, subject, std::move(files), interrupted)
                                : refusal(unread);
      if (interrupted) break;  // what it has is of a search that was cut short
      row["id"] = id;
      row["name"] = subject.name;
      row["seconds"] =
          std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
      log << row.dump() << std::endl;
      rows.push_back(std::move(row));
    }
  }
  const int failed = finish(arguments, rows);
  return interrupted ? exit_code::kInterrupted : failed;
}

}  // namespace

void add_study_imports(Command parent, int& status) {
  const auto arguments = std::make_shared<StudyImportsArguments>();
  Command command = parent.add_command(
      "imports", "Import, close and plan every label map of a folder without manual intervention");
  command
      .add_option(
          "folder", arguments->folder,
          "Folder of label maps (.nrrd, .nii, .mha, .gz, .bz2), each imported by itself; the "
          "files of each subfolder are imported together")
      .required();
  command
      .add_option("-o,--output", arguments->directory,
                  "Directory for imports.csv, imports.json, the valves and pictures")
      .show_default();
  command
      .add_option("--evaluations", arguments->evaluations,
                  "Closures for a plan search on each valve that closes (0: no search)")
      .check(number_from(0, 100000))
      .show_default();
  command.add_option("--seed", arguments->seed, "Random seed for synthesised chordae")
      .check(number_from(0, 2147483647))
      .show_default();
  command.add_flag("--pictures", arguments->pictures,
                   "Write a picture of each import: the input beside the resulting valve");
  command.add_flag("--json", arguments->json, "Print the summary as JSON");
  command.footer(
      "An interrupted study resumes when run again with the same directory; unchanged files are "
      "not\nimported again. The outcome of a map is refused, imported, closed (its closure is "
      "reliable) or\nplanned.\n\n"
      "Example:\n"
      "  coapt study imports labels/ -o mvseg --pictures");
  command.on_run([arguments, &status] { status = run(*arguments); });
}

}  // namespace coapt
