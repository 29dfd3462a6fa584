// Every label map of a folder: whether it is imported, closes and is repaired with nothing touched, and what must be looked at.
#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "clients/cli/commands.h"
#include "clients/cli/farm_option.h"
#include "clients/cli/import_inputs.h"
#include "core/valve/counted.h"
#include "core/valve/printable.h"
#include "farm/work/import_work.h"
#include "io/command_line/command_line.h"
#include "io/command_line/exit_code.h"
#include "io/command_line/files.h"
#include "io/command_line/interrupt.h"
#include "io/command_line/progress_bar.h"
#include "io/exchange/slicerheart.h"
#include "io/json/parse_json.h"
#include "io/json/subject.h"
#include "io/json/version.h"
#include "io/picture/csv_lines.h"
#include "io/picture/import_picture.h"
#include "search/threads.h"

namespace coapt {
namespace {

namespace fs = std::filesystem;

struct StudyImportsArguments {
  std::string folder, farm, directory = "study-imports";
  int evaluations = 0, seed = 1;
  bool pictures = false, json = false;
};

constexpr std::size_t kBytesAtOnce = std::size_t{256} << 20;  // of the files that are asked about

/// One import: a label map, or the files of a folder.
struct Subject {
  std::string name;
  std::vector<std::string> paths;
  bool slicerheart = false;  ///< such a folder
};

struct Subjects {
  std::vector<Subject> all;
  int left_out = 0;  ///< entries of the folder that are neither
};

Expected<Subjects> subjects_in(const std::string& folder) {
  std::error_code failed;
  Subjects found;
  std::vector<Subject>& subjects = found.all;
  for (auto entry = fs::directory_iterator(folder, failed);
       !failed && entry != fs::directory_iterator(); entry.increment(failed)) {
    std::error_code ignored;
    Subject subject{entry->path().filename(), {}};
    if (entry->is_directory(ignored)) {
      if (const auto files = files_of(entry->path())) subject.paths = importable(*files).paths;
      subject.slicerheart = is_slicerheart_folder(subject.paths);
    } else if (entry->is_regular_file(ignored) && is_label_map_format(format_of(subject.name))) {
      subject.paths = {entry->path()};
    }
    if (!subject.paths.empty())
      subjects.push_back(std::move(subject));
    else if (!subject.name.starts_with('.'))
      ++found.left_out;
  }
  if (failed) return Error{ErrorCode::InputOutput, "", "cannot be opened as a folder"};
  if (subjects.empty())
    return Error{ErrorCode::MissingField, "",
                 "has no label map (.nrrd, .nii, .mha, .gz, .bz2) and no folder with files"};
  std::sort(subjects.begin(), subjects.end(),
            [](const Subject& a, const Subject& b) { return a.name < b.name; });
  return found;
}

/// What was done before, by the id of its bytes. A line that a killed study left half is not there.
std::map<std::string, Json> kept_rows(const std::string& path) {
  std::map<std::string, Json> rows;
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);)
    if (const Expected<Json> row = parse_json(line);
        row && row->is_object() && row->value("id", Json()).is_string() && row->contains("stage"))
      rows[row->at("id").get<std::string>()] = *row;
  return rows;
}

/// Whether a study that was killed left its last line half.
bool is_torn(const std::string& path) {
  std::ifstream file(path, std::ios::binary | std::ios::ate);
  if (!file || file.tellg() <= 0) return false;
  file.seekg(-1, std::ios::end);
  return file.get() != '\n';
}

std::string table_of(const std::vector<Json>& rows) {
  CsvLines csv("name,stage,looks,leak_mm2,plan_leak_mm2,reason,first_look");
  for (const Json& row : rows) {
    const Json looks = row.value("looks", Json::array());
    csv << row["name"].get<std::string>() << row["stage"].get<std::string>()
        << static_cast<int>(looks.size()) << row.value("leak_mm2", std::nan(""))
        << row.value("plan_leak_mm2", std::nan("")) << row.value("reason", std::string())
        << (looks.empty() ? std::string() : looks[0].get<std::string>());
    csv.end_line();
  }
  return csv.text();
}

/// What messages have in common: without their numbers.
std::string without_numbers(std::string reason) {
  std::erase_if(reason, [](unsigned char c) { return std::isdigit(c) != 0; });
  return reason;
}

/// How often each reason is there, by the first of those that differ in numbers alone.
std::map<std::string, int> counted_reasons(const std::vector<Json>& rows) {
  std::map<std::string, std::string> firsts;
  std::map<std::string, int> counts;
  for (const Json& row : rows)
    if (const std::string reason = row.value("reason", std::string()); !reason.empty())
      ++counts[firsts.try_emplace(without_numbers(reason), reason).first->second];
  return counts;
}

Json summary_of(const std::vector<Json>& rows, int left_out) {
  std::map<std::string, int> stages, looks;
  int unlooked = 0;
  for (const Json& row : rows) {
    ++stages[row["stage"].get<std::string>()];
    const Json said = row.value("looks", Json::array());
    for (const Json& look : said) {
      const std::string text = look.get<std::string>();
      ++looks[text.substr(0, text.find(':'))];
    }
    if (row["stage"] != "refused" && said.empty()) ++unlooked;
  }
  Json summary =
      result_document("coapt.imports_study/1", {{"maps", rows.size()}, {"left_out", left_out}});
  for (const char* stage : kImportStages) summary["stages"][stage] = stages[stage];
  summary["nothing_to_look_at"] = unlooked;
  summary["reasons"] = counted_reasons(rows);
  summary["looks"] = looks;
  return summary;
}

int finish(const StudyImportsArguments& arguments, const std::vector<Json>& rows, int left_out) {
  const fs::path directory = arguments.directory;
  Json summary = summary_of(rows, left_out);
  Json document = summary;
  document["imports"] = rows;
  if (const int failed = write_output(directory / "imports.csv", table_of(rows))) return failed;
  if (const int failed = write_output(directory / "imports.json", json_text(document, 2) + '\n'))
    return failed;
  if (arguments.json) {
    std::cout << json_text(summary, 2) << '\n';
    return exit_code::kOk;
  }
  for (const char* stage : kImportStages)
    std::cout << stage << ": " << summary["stages"][stage] << " of " << rows.size() << '\n';
  std::cout << "imported without a decision to check: " << summary["nothing_to_look_at"] << '\n';
  for (const auto& [reason, count] : summary["reasons"].items())
    std::cout << count << " x " << printable(reason) << '\n';
  if (left_out > 0)
    std::cout << counted(left_out, "entry", "entries")
              << " of the folder not used: neither label maps nor folders with files of a valve\n";
  std::cout << "Written to " << printable((directory / "imports.csv").string()) << '\n';
  return exit_code::kOk;
}

/// Imports whose files were read, and the rows that they will have.
struct Pending {
  std::vector<ImportCase> cases;
  std::vector<std::string> ids;
  std::vector<std::size_t> rows;
  std::size_t bytes = 0;
};

class ImportsStudy {
 public:
  ImportsStudy(const StudyImportsArguments& arguments, std::vector<Subject> subjects,
               const std::atomic<bool>& interrupted)
      : arguments_(arguments),
        subjects_(std::move(subjects)),
        interrupted_(interrupted),
        asker_(asker_of(arguments.farm, 0)),
        rows_(subjects_.size()) {
    const std::string path = fs::path(arguments.directory) / "imports.jsonl";
    kept_ = kept_rows(path);
    const bool torn = is_torn(path);
    log_.open(path, std::ios::app);
    if (torn) log_ << '\n';
  }

  /// Errors: what became of the asking.
  Errors run() {
    // A farm takes many at once; here each row is kept soon after it is made.
    const std::size_t at_once = !arguments_.farm.empty()     ? std::size_t{10'000}
                                : arguments_.evaluations > 0 ? std::size_t{1}
                                                             : std::size_t(all_cores());
    Pending pending;
    for (std::size_t i = 0; i < subjects_.size() && !interrupted_; ++i) {
      take(i, pending);
      const bool is_last = i + 1 == subjects_.size();
      if (pending.cases.size() < at_once && pending.bytes < kBytesAtOnce && !is_last) continue;
      if (Errors errors = ask(pending); !errors.empty()) return errors;
      pending = {};
    }
    return {};
  }

  /// Those that are known, in the order of the folder.
  std::vector<Json> rows() const {
    std::vector<Json> known;
    std::copy_if(rows_.begin(), rows_.end(), std::back_inserter(known),
                 [](const Json& row) { return !row.is_null(); });
    return known;
  }

 private:
  /// Its row is known, or it is pending.
  void take(std::size_t index, Pending& pending) {
    const Subject& subject = subjects_[index];
    ImportCase one{subject.name, {}, subject.slicerheart};
    std::vector<std::string> paths = subject.paths;
    Expected<std::vector<NamedFile>> files = read_with_companions(paths);
    if (!files) {
      rows_[index] = {{"name", subject.name},
                      {"stage", "refused"},
                      {"reason", files.errors()[0].message},
                      {"looks", Json::array()}};
      return;
    }
    one.files = *std::move(files);
    std::size_t bytes = 0;
    std::string all = closures_revision() + ' ' + std::to_string(arguments_.evaluations) + ' ' +
                      std::to_string(arguments_.seed);
    for (const NamedFile& file : one.files) {
      bytes += file.bytes.size();
      all += '\n' + file.name + '\n' + fnv1a_128(file.bytes);
    }
    std::string id = fnv1a_128(all);
    if (const auto found = kept_.find(id); found != kept_.end() && is_whole(found->second)) {
      rows_[index] = found->second;
      rows_[index]["name"] = subject.name;
      return;
    }
    pending.cases.push_back(std::move(one));
    pending.ids.push_back(std::move(id));
    pending.rows.push_back(index);
    pending.bytes += bytes;
  }

  /// Whether its files are still there, and all that are asked for.
  bool is_whole(const Json& row) const {
    const fs::path directory = arguments_.directory;
    std::error_code ignored;
    if (!row.contains("valve")) return true;
    if (!row["valve"].is_string()) return false;
    const fs::path valve = row["valve"].get<std::string>();
    const fs::path picture = "pictures" / valve.stem().concat(".png");
    return fs::exists(directory / valve, ignored) &&
           (!arguments_.pictures || fs::exists(directory / picture, ignored));
  }

  Errors ask(const Pending& pending) {
    if (pending.cases.empty() || interrupted_) return {};
    const auto known = static_cast<int>(rows().size());
    const auto show = [&](const AskProgress& now) {
      bar_.show(known + static_cast<int>(now.done), static_cast<int>(subjects_.size()), "imports");
    };
    show({});
    const Expected<std::string> bytes =
        asker_(imports_request(pending.cases, {arguments_.seed, arguments_.evaluations}),
               {"coapt study imports", show, &interrupted_});
    if (!bytes) return interrupted_ ? Errors{} : bytes.errors();
    const Expected<std::vector<ImportOutcome>> outcomes = import_outcomes(*bytes);
    if (!outcomes) return outcomes.errors();
    if (outcomes->size() != pending.cases.size())
      return {Error{ErrorCode::InputOutput, "", "the farm returned another number of imports"}};
    for (std::size_t i = 0; i < outcomes->size(); ++i)
      keep(pending.cases[i], (*outcomes)[i], pending.ids[i], rows_[pending.rows[i]]);
    return {};
  }

  /// Its valve and picture are written below the directory.
  void keep(const ImportCase& one, const ImportOutcome& outcome, const std::string& id, Json& row) {
    const fs::path directory = arguments_.directory;
    row = outcome.row;
    row["id"] = id;
    row["name"] = one.name;
    if (!outcome.valve.empty()) {
      const std::string file = "valves/" + one.name + ".json";
      const bool is_written = write_output(directory / file, outcome.valve) == exit_code::kOk;
      row["valve"] = is_written ? Json(file) : Json();
      if (arguments_.pictures) draw(one);
    }
    log_ << json_text(row) << std::endl;
  }

  void draw(const ImportCase& one) const {
    if (const Expected<ImportedValve> made = make_import(as_request(one, arguments_.seed), {});
        made && is_mitral(made->valve))
      (void)write_output(fs::path(arguments_.directory) / "pictures" / (one.name + ".png"),
                         import_picture_png(*made, one.name));
  }

  const StudyImportsArguments& arguments_;
  std::vector<Subject> subjects_;
  const std::atomic<bool>& interrupted_;
  Asker asker_;
  std::vector<Json> rows_;  ///< of the subjects; null: not yet known
  std::map<std::string, Json> kept_;
  std::ofstream log_;
  ProgressBar bar_;
};

int run(const StudyImportsArguments& arguments) {
  const std::atomic<bool>& interrupted = catch_interrupts();
  Expected<Subjects> subjects = subjects_in(arguments.folder);
  if (!subjects) return report_errors(arguments.folder, subjects.errors());
  const fs::path directory = arguments.directory;
  for (const fs::path& path : {directory / "valves", directory / "pictures"})
    if (const Errors errors = make_directory(path); !errors.empty()) {
      report_errors("study imports", errors);
      return exit_code::kFailure;
    }
  std::vector<Json> rows;
  {
    ImportsStudy study(arguments, std::move(subjects->all), interrupted);
    if (const Errors errors = study.run(); !errors.empty()) {
      report_errors("study imports", errors);
      return exit_code::kFailure;
    }
    rows = study.rows();
  }
  const int failed = finish(arguments, rows, subjects->left_out);
  if (interrupted)
    std::cerr << "coapt: study imports: interrupted; the same command resumes the study\n";
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
  add_farm_option(command, arguments->farm, "Import, close and plan the maps");
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
