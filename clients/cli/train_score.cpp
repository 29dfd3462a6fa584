#include <iomanip>
#include <iostream>
#include <memory>
#include <string>

#include "clients/cli/commands.h"
#include "io/command_line/exit_code.h"
#include "io/command_line/files.h"
#include "io/json/schedule_json.h"
#include "io/json/score_json.h"
#include "io/json/trials_csv.h"
#include "io/picture/text.h"
#include "search/training/seeds.h"

namespace coapt {
namespace {

struct TrainExamArguments {
  std::string schedule;
  std::uint64_t seed = 1, first_case = 1;
  bool json = false;
};

struct TrainScoreArguments {
  std::string trials;
  bool json = false;
};

void print_exam(const Json& exam) {
  std::cout << printable(exam["title"].get<std::string>()) << '\n';
  for (const auto& block : exam["blocks"]) {
    std::cout << '\n' << printable(block["name"].get<std::string>()) << ": ";
    if (block.contains("instruction")) {
      std::cout << printable(block["instruction"].get<std::string>()) << '\n';
      continue;
    }
    std::cout << "exam " << block["exam"].get<std::string>();
    if (block["seconds"] > 0) std::cout << ", at most " << block["seconds"] << " s a trial";
    std::cout << "; seeds of the cases in order:";
    for (const auto& trial : block["trials"]) std::cout << ' ' << trial["seed"];
    std::cout << '\n';
  }
}

void print_scores(const Json& result) {
  std::cout
      << "learner exam  block            right        share (95 %)      chance  p      Brier  "
         "s     ability\n";
  for (const auto& score : result["scores"]) {
    const std::string block =
        score["block"].is_null() ? "all" : printable(score["block"].get<std::string>());
    std::cout << std::setw(7) << score["learner"].get<int>() << ' ' << std::left << std::setw(6)
              << score["exam"].get<std::string>() << std::setw(16) << block << std::right
              << std::setw(5) << score["right"].get<int>() << " of " << std::setw(4)
              << score["answers"].get<int>() << std::setw(8) << percent(score["share"]) << " ("
              << percent(score["interval95"][0]) << " to " << percent(score["interval95"][1])
              << ")  " << percent(score["chance"]) << "  " << fixed(score["by_chance"], 3) << "  "
              << fixed(score["brier"], 3) << "  " << fixed(score["seconds"], 0) << "  "
              << fixed(score["ability"], 1) << " ± " << fixed(score["ability_se"], 1) << '\n';
  }
  for (const auto& next : result["next"]) {
    std::cout << "Learner " << next["learner"] << ", exam " << next["exam"].get<std::string>()
              << ": next case of difficulty " << fixed(next["difficulty"], 1);
    if (!next["repeat"].empty()) {
      std::cout << "; repeat seeds";
      for (const auto& repeated : next["repeat"]) std::cout << ' ' << repeated["seed"];
    }
    std::cout << '\n';
  }
}

int run(const TrainExamArguments& arguments) {
  const Expected<std::string> text = read_input(arguments.schedule);
  if (!text) return report_errors(arguments.schedule, text.errors());
  const Expected<Schedule> schedule = read_schedule(*text);
  if (!schedule) return report_errors(arguments.schedule, schedule.errors());
  const auto exam = exam_to_json(*schedule, arguments.seed, arguments.first_case);
  if (arguments.json) {
    std::cout << json_text(exam, 2) << '\n';
  } else {
    print_exam(exam);
  }
  return exit_code::kOk;
}

int run(const TrainScoreArguments& arguments) {
  const Expected<std::string> text = read_input(arguments.trials);
  if (!text) return report_errors(arguments.trials, text.errors());
  const Expected<std::vector<TrainingTrial>> trials = read_trials_csv(*text);
  if (!trials) return report_errors(arguments.trials, trials.errors());
  const Json scores = score_to_json(*trials);
  if (arguments.json) {
    std::cout << json_text(scores, 2) << '\n';
  } else {
    print_scores(scores);
  }
  return exit_code::kOk;
}

}  // namespace

void add_train_exam(Command parent, int& status) {
  const auto arguments = std::make_shared<TrainExamArguments>();
  Command command = parent.add_command(
      "exam", "Generate the trials and instructions of a schedule for a learner");
  command
      .add_option(
          "schedule", arguments->schedule,
          "Schedule (coapt.training_schedule/1; three in examples/training), - for standard "
          "input")
      .required();
  command
      .add_option("--seed", arguments->seed,
                  "Random seed of the learner, which sets the order of the trials")
      .check(number_from(std::uint64_t{0}, kLargestSeed))
      .required();
  command
      .add_option("--first-case", arguments->first_case,
                  "Seed of the first case, the same for all learners")
      .check(number_from(std::uint64_t{0}, kLargestFirstCase))
      .show_default();
  command.add_flag("--json", arguments->json, "Print JSON (coapt.training_exam/1)");
  command.footer(
      "Some seeds make no case. coapt train raters --first-case N --cases M counts such seeds of a "
      "study;\nif there are any, use another --first-case for all learners.\n\n"
      "Examples:\n"
      "  coapt train exam examples/training/study-1.json --seed 4\n"
      "  coapt train exam examples/training/study-1.json --seed 4 --first-case 101");
  command.on_run([arguments, &status] { status = run(*arguments); });
}

void add_train_score(Command parent, int& status) {
  const auto arguments = std::make_shared<TrainScoreArguments>();
  Command command = parent.add_command(
      "score", "Score trials: correct answers, confidence, ability and the next case");
  command
      .add_option(
          "trials", arguments->trials,
          "Table of trials (CSV, one row per trial; docs/training.md), - for standard input")
      .required();
  command.add_flag("--json", arguments->json, "Print JSON (coapt.training_score/1)");
  command.footer(
      "Example:\n"
      "  coapt train score trials.csv --json");
  command.on_run([arguments, &status] { status = run(*arguments); });
}

}  // namespace coapt
