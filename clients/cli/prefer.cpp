#include <unistd.h>

#include <algorithm>
#include <iostream>
#include <map>
#include <memory>
#include <string>

#include "clients/cli/commands.h"
#include "clients/cli/preference_inputs.h"
#include "clients/cli/print.h"
#include "clients/cli/print_preference.h"
#include "io/command_line/exit_code.h"
#include "io/command_line/files.h"
#include "io/json/preference_json.h"
#include "io/picture/text.h"
#include "search/preference/raters.h"

namespace coapt {
namespace {

struct PreferArguments {
  std::vector<std::string> plans;
  std::string answers, output, compare, rater;
  Preference answer = Preference::Unable;
  bool answered = false, next = false, json = false, hide_figures = false;
};

struct Interview {
  const PreferArguments& arguments;
  const PreferenceCases& of;
  AnswerSheet sheet;
};

PreferencePosterior posterior_of(const Interview& interview) {
  return posterior_of(interview.of.cases, interview.sheet.answers);
}

/// With the file of each case.
Json first_places_json(const Interview& interview, const PosteriorDraws& draws) {
  const PreferenceCases& of = interview.of;
  auto json = first_places_to_json(of.cases, draws);
  for (auto& place : json)
    for (std::size_t i = 0; i < of.cases.size(); ++i)
      if (place["case"] == of.cases[i].name) place["file"] = of.files[i];
  return json;
}

int add_answer(Interview& interview, const Question& question, Preference given) {
  interview.sheet.answers.push_back({question.pair, given});
  return write_answers_file(interview.arguments.answers, interview.sheet, interview.of.cases);
}

int print_next(const Interview& interview) {
  const PosteriorDraws draws = draw(posterior_of(interview));
  const auto question = next_question(interview.of.cases, interview.sheet.answers, draws);
  Json json = {{"schema", "coapt.question/1"},
               {"answers", interview.sheet.answers.size()},
               {"question", nullptr},
               {"first_places", first_places_json(interview, draws)}};
  if (question)
    json["question"] = to_json(*question, interview.of.cases, interview.arguments.hide_figures);
  std::cout << json_text(json, 2) << '\n';
  return exit_code::kOk;
}

/// To the question that --next printed, which depends on the answers before it alone.
int take_answer(Interview& interview) {
  const auto question =
      next_question(interview.of.cases, interview.sheet.answers, draw(posterior_of(interview)));
  if (!question)
    return report_errors("prefer", {{ErrorCode::OutOfRange, "--answer", "no question is left"}});
  return add_answer(interview, *question, interview.arguments.answer);
}

/// None to end.
std::optional<Preference> asked(std::istream& in, std::ostream& out) {
  for (std::string line;;) {
    out << "Which plan do you prefer? 1, 2, 0 (cannot decide), q (quit): " << std::flush;
    if (!std::getline(in, line) || line == "q") return {};
    if (line == "1") return Preference::First;
    if (line == "2") return Preference::Second;
    if (line == "0") return Preference::Unable;
  }
}

int ask(Interview& interview) {
  for (;;) {
    const PosteriorDraws draws = draw(posterior_of(interview));
    const std::size_t count = interview.sheet.answers.size();
    if (count > 0) {
      std::cout << '\n' << counted(static_cast<long>(count), "answer");
      for (const auto& place : first_places_json(interview, draws))
        std::cout << "; best of " << printable(place["file"].get<std::string>()) << ": plan "
                  << place["rank"] << " (" << percent(place["probability"]) << " sure)";
      std::cout << '\n';
    }
    const auto question = next_question(interview.of.cases, interview.sheet.answers, draws);
    if (!question) {
      std::cout << "No question is left.\n\n";
      return exit_code::kOk;
    }
    std::cout << '\n';
    print_question(std::cout,
                   to_json(*question, interview.of.cases, interview.arguments.hide_figures));
    const std::optional<Preference> given = asked(std::cin, std::cout);
    if (!given) {
      std::cout << '\n';
      return exit_code::kOk;
    }
    if (const int failed = add_answer(interview, *question, *given)) return failed;
  }
}

int compare(const Interview& interview) {
  const PreferArguments& arguments = interview.arguments;
  const AnswersFile other = read_answers_file(arguments.compare, interview.of.cases, "");
  if (other.failed) return other.failed;
  const Agreement found = agreement(interview.sheet.answers, other.sheet.answers);
  const Json kappa = found.kappa ? Json(*found.kappa) : Json();
  if (arguments.json) {
    const Json json = {{"schema", "coapt.agreement/1"},
                       {"raters", {interview.sheet.rater, other.sheet.rater}},
                       {"pairs", found.pairs},
                       {"alike", found.pairs > 0 ? Json(found.share) : kappa},
                       {"kappa", kappa}};
    std::cout << json_text(json, 2) << '\n';
  } else {
    std::cout << counted(found.pairs, "pair") << " answered by both";
    if (found.pairs > 0) std::cout << ", " << percent(found.share) << " of them the same way";
    std::cout << "; Cohen's kappa " << fixed(number_of(kappa), 2) << '\n';
  }
  return exit_code::kOk;
}

int run(const PreferArguments& arguments) {
  const PreferenceCases cases = read_cases(arguments.plans);
  if (cases.failed) return cases.failed;
  const AnswersFile answers = read_answers_file(arguments.answers, cases.cases, arguments.rater);
  if (answers.failed) return answers.failed;
  if (const int failed = check_output(arguments.output)) return failed;
  Interview interview{arguments, cases, answers.sheet};
  if (!arguments.compare.empty()) return compare(interview);

  const bool terminal = isatty(STDIN_FILENO) != 0 && isatty(STDOUT_FILENO) != 0;
  const bool asks = terminal && !arguments.json && !arguments.next && !arguments.answered;
  if (arguments.answered)
    if (const int failed = take_answer(interview)) return failed;
  if (asks)
    if (const int failed = ask(interview)) return failed;
  if (arguments.next || (!asks && !arguments.json && arguments.output.empty()))
    return print_next(interview);

  const Json weights =
      learned_to_json(cases.cases, interview.sheet.answers, posterior_of(interview));
  if (!arguments.output.empty())
    if (const int failed = write_output(arguments.output, weights.dump(2) + '\n')) return failed;
  if (arguments.json) {
    std::cout << json_text(weights, 2) << '\n';
  } else {
    print_weights(std::cout, weights);
  }
  return exit_code::kOk;
}

}  // namespace

void add_prefer(Command parent, int& status) {
  const auto arguments = std::make_shared<PreferArguments>();
  Command command = parent.add_command(
      "prefer", "Learn cost weights from an expert's pairwise comparisons of plans");
  command.add_option("plans", arguments->plans, "Output of coapt plan --json, one file per case")
      .required();
  command
      .add_option("--answers", arguments->answers,
                  "File of answers (coapt.answers/1); new answers are added, and the file is "
                  "created if missing")
      .required()
      .check({refuse_standard_output, "FILE"});
  command.add_option("-o,--output", arguments->output, "Write the weights (coapt.weights/1)")
      .check({refuse_standard_output, "FILE"});
  command.add_option("--rater", arguments->rater, "Name of the rater, stored with the answers");
  command.add_flag("--hide-figures", arguments->hide_figures,
                   "Show the steps of each plan only, without leak, opening and reserve");
  command.add_flag("--next", arguments->next, "Print the next question as JSON and exit");
  const std::map<std::string, Preference> words = {
      {"first", Preference::First}, {"second", Preference::Second}, {"unable", Preference::Unable}};
  command
      .add_choice("--answer", arguments->answer, words,
                  "Record an answer to that question first: first, second or unable")
      .show_argument("ANSWER");
  command.add_option("--compare", arguments->compare,
                     "Answers of another rater on the same plans; print the agreement of the two");
  command.add_flag("--json", arguments->json,
                   "Print JSON (coapt.weights/1) without asking questions");
  command.footer(
      "On a terminal, coapt asks which of two plans you prefer, always choosing the pair expected "
      "to be\nmost informative; every tenth question repeats an earlier one with sides swapped. "
      "Elsewhere it\nprints the next question (coapt.question/1), unless weights are requested. "
      "Weights that no answer\nconstrains keep their defaults and are listed.\n\n"
      "Examples:\n"
      "  coapt prefer functional.json prolapse.json --answers mine.json -o weights.json\n"
      "  coapt prefer functional.json --answers mine.json --answer first --next\n"
      "  coapt prefer functional.json --answers mine.json --compare yours.json\n"
      "  coapt plan valve.json --weights weights.json");
  command.on_run([arguments, command, &status] {
    arguments->answered = command.has("--answer");
    status = run(*arguments);
  });
}

}  // namespace coapt
