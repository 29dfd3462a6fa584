#include <cmath>
#include <iostream>
#include <memory>

#include "clients/cli/commands.h"
#include "io/command_line/exit_code.h"
#include "io/command_line/files.h"
#include "io/json/version.h"
#include "io/picture/text.h"
#include "search/training/binomial.h"

namespace coapt {
namespace {

constexpr double kLeastShare = 0.001, kLargestShare = 0.999;

struct TrainPowerArguments {
  double share = 0.0, other = 0.0;
  double power = 0.8, design_effect = 1.5;
  int answers = 10;
  bool json = false;
};

int run(const TrainPowerArguments& arguments) {
  if (arguments.share == arguments.other)
    return report_errors("Q", Errors{{ErrorCode::OutOfRange, "", "is P, must differ from it"}});
  const int needed = answers_to_tell(arguments.share, arguments.other, arguments.power);
  const auto people = [&](double design_effect) {
    return static_cast<int>(std::ceil(design_effect * needed / arguments.answers));
  };
  const Json result = result_document(
      "coapt.training_power/1", {{"shares", {arguments.share, arguments.other}},
                                 {"power", arguments.power},
                                 {"answers_each", arguments.answers},
                                 {"design_effect", arguments.design_effect},
                                 {"answers_a_group", needed},
                                 {"people_a_group", people(1.0)},
                                 {"people_a_group_correlated", people(arguments.design_effect)}});
  if (arguments.json) {
    std::cout << json_text(result, 2) << '\n';
    return exit_code::kOk;
  }
  std::cout << percent(arguments.share) << " against " << percent(arguments.other)
            << " of correct answers, power " << percent(arguments.power)
            << " at 5 %, two-sided:\n  " << counted(needed, "answer") << " a group; with "
            << counted(arguments.answers, "answer") << " each " << people(1.0)
            << " people a group, " << people(arguments.design_effect) << " with a design effect of "
            << fixed(arguments.design_effect, 1) << '\n';
  return exit_code::kOk;
}

}  // namespace

void add_train_power(Command parent, int& status) {
  const auto arguments = std::make_shared<TrainPowerArguments>();
  Command command = parent.add_command(
      "power",
      "Calculate how many learners a study needs to tell two proportions of correct answers apart");
  command.add_option("p", arguments->share, "Proportion of correct answers in one group")
      .check(number_from(kLeastShare, kLargestShare))
      .required();
  command.add_option("q", arguments->other, "Proportion of correct answers in the other")
      .check(number_from(kLeastShare, kLargestShare))
      .required();
  command.add_option("--answers", arguments->answers, "Number of answers of each learner")
      .check(number_from(1, 100000))
      .show_default();
  command.add_option("--power", arguments->power, "Probability of finding the difference")
      .check(number_from(0.5, kLargestShare))
      .show_default();
  command
      .add_option(
          "--design-effect", arguments->design_effect,
          "Design effect: factor on the number of answers, because the answers of one learner "
          "are correlated")
      .check(number_from(1.0, 100.0))
      .show_default();
  command.add_flag("--json", arguments->json, "Print JSON (coapt.training_power/1)");
  command.footer(
      "A normal approximation without continuity correction (Fleiss 1981), 5 % two-sided. An "
      "answer "
      "is a\ntrial of exam A or a segment of exam B: 8 a case.\n\n"
      "Example:\n"
      "  coapt train power 0.33 0.44 --answers 24    # exam B: guessing against 44 %, 3 cases "
      "each");
  command.on_run([arguments, &status] { status = run(*arguments); });
}

}  // namespace coapt
