#include <filesystem>
#include <iostream>
#include <memory>
#include <string>

#include "clients/cli/commands.h"
#include "clients/cli/read_argument.h"
#include "io/command_line/exit_code.h"
#include "io/command_line/files.h"
#include "io/json/training_json.h"
#include "io/json/valve_json.h"
#include "io/picture/picture.h"
#include "io/picture/text.h"
#include "io/picture/training_picture.h"
#include "search/training/seeds.h"

namespace coapt {
namespace {

enum class Exam { A, B };

struct TrainCaseArguments {
  std::string valve = "human-normal", directory;
  Exam exam = Exam::A;
  std::uint64_t seed = 1;
  bool json = false;
};

/// Makes the directory of a case and writes into it; the first failure ends it.
class CaseDirectory {
 public:
  explicit CaseDirectory(std::string path) : path_(std::move(path)) {
    if (const Errors errors = make_directory(path_); !errors.empty())
      failed_ = report_errors(path_, errors);
  }

  void write(const std::string& name, const std::string& bytes) {
    if (failed_ == exit_code::kOk)
      failed_ = write_output((std::filesystem::path(path_) / name).string(), bytes);
  }
  int failed() const { return failed_; }

 private:
  std::string path_;
  int failed_ = exit_code::kOk;
};

void print_case(const Json& made, const std::string& directory) {
  std::cout << "Exam " << made["exam"].get<std::string>() << ", seed " << made["seed"] << ", of "
            << printable(made["name"].get<std::string>()) << ": difficulty "
            << fixed(made["difficulty"], 2) << " (smallest difference "
            << fixed(made["smallest_difference"], 2) << " times the limit)\n";
  if (made.contains("answer")) {
    std::cout << "Choice " << made["answer"] << " is the valve shown without pressure.\n";
  } else {
    for (const auto& segment : made["segments"])
      std::cout << "  " << segment["segment"].get<std::string>() << "  "
                << fixed(segment["change_mm"], 1) << " mm  "
                << segment["mobility"].get<std::string>() << '\n';
  }
  std::cout << "Written to " << printable(directory) << ": case.json, valves and pictures\n";
}

int finish(const TrainCaseArguments& arguments, CaseDirectory& directory, const Json& made) {
  directory.write("case.json", made.dump(2) + '\n');
  if (directory.failed()) return directory.failed();
  if (arguments.json) {
    std::cout << json_text(made, 2) << '\n';
  } else {
    print_case(made, arguments.directory);
  }
  return exit_code::kOk;
}

int write_exam_a(const TrainCaseArguments& arguments, const Valve& valve) {
  const Expected<ExamACase> made = make_exam_a(valve, arguments.seed);
  if (!made) return report_errors(arguments.valve, made.errors());
  Json json = to_json(*made, valve);
  CaseDirectory directory(arguments.directory);
  std::array<const ClosedValve*, kChoices> closed{};
  for (std::size_t i = 0; i < kChoices; ++i) {
    const std::string file = "choice-" + std::to_string(i + 1) + ".json";
    json["choices"][i]["file"] = file;
    closed[i] = &made->choices[i].closed;
    directory.write(file, write_valve(closed[i]->valve));
  }
  const CaseChoice& shown = made->choices[made->answer];
  directory.write("choices.png", choices_picture_png(closed));
  directory.write("flaccid.png", flaccid_picture_png(shown.closed.valve, shown.flaccid_mm));
  return finish(arguments, directory, json);
}

int write_exam_b(const TrainCaseArguments& arguments, const Valve& valve) {
  const Expected<ExamBCase> made = make_exam_b(valve, arguments.seed);
  if (!made) return report_errors(arguments.valve, made.errors());
  Json json = to_json(*made, valve);
  json["file"] = "valve.json";
  CaseDirectory directory(arguments.directory);
  directory.write("valve.json", write_valve(made->closed.valve));
  directory.write("closed.png", closure_picture_png(made->closed));
  directory.write("flaccid.png", flaccid_picture_png(made->closed.valve, made->flaccid_mm));
  return finish(arguments, directory, json);
}

int run(const TrainCaseArguments& arguments) {
  const Expected<Valve> valve = read_valve_argument(arguments.valve);
  if (!valve) return report_errors(arguments.valve, valve.errors());
  return arguments.exam == Exam::A ? write_exam_a(arguments, *valve)
                                   : write_exam_b(arguments, *valve);
}

void add_train_case(Command parent, int& status) {
  const auto arguments = std::make_shared<TrainCaseArguments>();
  Command command = parent.add_command(
      "case", "Make a case: valves that look alike until they are pulled or closed");
  command.add_option("valve", arguments->valve, kValveHelp).show_default();
  const std::map<std::string, Exam> exams = {{"A", Exam::A}, {"B", Exam::B}};
  command
      .add_choice("--exam", arguments->exam, exams,
                  "A: identify the valve among four closed ones; B: classify each segment as "
                  "tethered, normal or prolapsing")
      .required()
      .show_argument("A|B");
  command.add_option("--seed", arguments->seed, "Random seed; the same seed makes the same case")
      .check(number_from(std::uint64_t{0}, kLargestSeed))
      .required();
  command
      .add_option("-o,--output", arguments->directory,
                  "Directory for case.json, valves and pictures")
      .check({refuse_standard_output, "DIR"})
      .required();
  command.add_flag("--json", arguments->json, "Print case.json (coapt.training_case/1)");
  command.footer(
      "Lesions change only chordal lengths and positions of papillary tips. case.json holds the "
      "answers, so\nshow learners the pictures only. Some seeds make no case; nothing is then "
      "written.\n\n"
      "Examples:\n"
      "  coapt train case --exam A --seed 7 -o case-7\n"
      "  coapt train case porcine-thesis --exam B --seed 7 -o case-7 --json");
  command.on_run([arguments, &status] { status = run(*arguments); });
}

}  // namespace

void add_train(Command parent, int& status) {
  Command train = parent.add_command("train", "Make, lay out and score exams in valve analysis");
  train.require_command();
  add_train_case(train, status);
  add_train_exam(train, status);
  add_train_score(train, status);
  add_train_raters(train, status);
  add_train_power(train, status);
}

}  // namespace coapt
