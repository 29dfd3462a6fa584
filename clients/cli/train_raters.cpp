#include <iomanip>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "clients/cli/commands.h"
#include "clients/cli/read_argument.h"
#include "io/command_line/exit_code.h"
#include "io/command_line/files.h"
#include "io/command_line/progress_bar.h"
#include "io/json/version.h"
#include "io/picture/text.h"
#include "search/random_share.h"
#include "search/training/binomial.h"
#include "search/training/scripted_raters.h"
#include "search/training/seeds.h"

namespace coapt {
namespace {

constexpr double kFeltError_mm = 0.5;  // of a height, assumed: a hand against the annular plane

struct TrainRatersArguments {
  std::string valve = "human-normal";
  int cases = 20;
  std::uint64_t first_case = 1;
  bool json = false;
};

struct RaterTally {
  const char* rater;
  int right = 0, answers = 0;
};

Json tallies_json(const std::vector<RaterTally>& tallies, double chance) {
  Json list = Json::array();
  for (const RaterTally& tally : tallies) {
    if (tally.answers == 0) continue;
    list.push_back({{"rater", tally.rater},
                    {"right", tally.right},
                    {"answers", tally.answers},
                    {"share", static_cast<double>(tally.right) / tally.answers},
                    {"interval95", share_interval(tally.right, tally.answers)},
                    {"chance", chance},
                    {"by_chance", chance_of_at_least(tally.right, tally.answers, chance)}});
  }
  return list;
}

void rate_exam_a(const ExamACase& made, const KnownValve& known, std::mt19937_64& engine,
                 std::vector<RaterTally>& tallies) {
  const std::array<std::size_t, 6> chosen = {
      std::min(kChoices - 1, static_cast<std::size_t>(random_share(engine) * kChoices)),
      made.answer,
      choose_by_looking(made, known, {}, engine),
      choose_by_looking(made, known, {.error_mm = 0.0}, engine),
      choose_by_pulling(made, known, kFeltError_mm, engine),
      choose_by_pulling(made, known, 0.0, engine)};
  for (std::size_t r = 0; r < chosen.size(); ++r) {
    ++tallies[r].answers;
    tallies[r].right += chosen[r] == made.answer ? 1 : 0;
  }
}

void rate_exam_b(const ExamBCase& made, const KnownValve& known, std::mt19937_64& engine,
                 std::vector<RaterTally>& tallies) {
  std::array<Mobility, kSegments> at_random{}, truth{};
  for (std::size_t s = 0; s < kSegments; ++s) {
    at_random[s] = static_cast<Mobility>(std::min(2, static_cast<int>(3.0 * random_share(engine))));
    truth[s] = made.truths[s].mobility;
  }
  const double limit_mm = ExamBRules{}.limit_mm;
  const std::array<std::array<Mobility, kSegments>, 6> judged = {
      at_random,
      truth,
      judge_by_looking(made, known, {}, engine),
      judge_by_looking(made, known, {.error_mm = 0.0}, engine),
      judge_by_pulling(made, kFeltError_mm, limit_mm, engine),
      judge_by_pulling(made, 0.0, limit_mm, engine)};
  for (std::size_t r = 0; r < judged.size(); ++r)
    for (std::size_t s = 0; s < kSegments; ++s) {
      ++tallies[r].answers;
      tallies[r].right += judged[r][s] == truth[s] ? 1 : 0;
    }
}

void print_raters(const Json& result) {
  for (const auto& exam : result["exams"]) {
    std::cout << "Exam " << exam["exam"].get<std::string>() << ", "
              << counted(exam["cases"].get<long>(), "case") << " ("
              << counted(exam["not_made"].get<long>(), "seed") << " made no case), "
              << fixed(exam["draws"], 1) << " valves drawn for each\n";
    for (const auto& rater : exam["raters"])
      std::cout << "  " << std::left << std::setw(34) << rater["rater"].get<std::string>()
                << std::right << std::setw(4) << rater["right"].get<int>() << " of " << std::setw(4)
                << rater["answers"].get<int>() << std::setw(7) << percent(rater["share"]) << " ("
                << percent(rater["interval95"][0]) << " to " << percent(rater["interval95"][1])
                << "), chance " << percent(rater["chance"]) << '\n';
  }
}

int run(const TrainRatersArguments& arguments) {
  const Expected<Valve> valve = read_valve_argument(arguments.valve);
  if (!valve) return report_errors(arguments.valve, valve.errors());
  if (const auto edge = free_edge(*valve); !edge)
    return report_errors(arguments.valve, edge.errors());
  const KnownValve known = known_valve(*valve);
  const std::vector<RaterTally> nothing = {{"at random"},
                                           {"knows"},
                                           {"looks, to 0.3 mm"},
                                           {"looks, to the computer's digits"},
                                           {"pulls, feels to 0.5 mm"},
                                           {"pulls, feels exactly"}};
  std::vector<RaterTally> of_a = nothing, of_b = nothing;
  std::mt19937_64 engine(arguments.first_case);
  int not_made_a = 0, not_made_b = 0, draws_a = 0, draws_b = 0;
  const ProgressBar bar;
  for (int i = 0; i < arguments.cases; ++i) {
    const std::uint64_t seed = arguments.first_case + static_cast<std::uint64_t>(i);
    bar.show(i, arguments.cases, "cases");
    if (const auto made = make_exam_a(*valve, seed)) {
      rate_exam_a(*made, known, engine, of_a);
      draws_a += made->draws;
    } else {
      ++not_made_a;
    }
    if (const auto made = make_exam_b(*valve, seed)) {
      rate_exam_b(*made, known, engine, of_b);
      draws_b += made->draws;
    } else {
      ++not_made_b;
    }
  }
  bar.show(arguments.cases, arguments.cases, "cases");
  const auto exam_json = [&](const char* exam, int not_made, int draws,
                             const std::vector<RaterTally>& tallies, double chance) -> Json {
    const int cases = arguments.cases - not_made;
    return {{"exam", exam},
            {"cases", cases},
            {"not_made", not_made},
            {"draws", cases > 0 ? static_cast<double>(draws) / cases : 0.0},
            {"raters", tallies_json(tallies, chance)}};
  };
  const Json result = result_document("coapt.training_raters/1",
                                      {{"name", valve->name},
                                       {"exams",
                                        {exam_json("A", not_made_a, draws_a, of_a, kChanceA),
                                         exam_json("B", not_made_b, draws_b, of_b, kChanceB)}}});
  if (arguments.json) {
    std::cout << json_text(result, 2) << '\n';
  } else {
    print_raters(result);
  }
  return exit_code::kOk;
}

}  // namespace

void add_train_raters(Command parent, int& status) {
  const auto arguments = std::make_shared<TrainRatersArguments>();
  Command command = parent.add_command(
      "raters",
      "Run scripted raters through exams, to check that answers require pulling the valve");
  command.add_option("valve", arguments->valve, kValveHelp).show_default();
  command.add_option("--cases", arguments->cases, "Number of cases of each exam")
      .check(number_from(1, 10000))
      .show_default();
  command.add_option("--first-case", arguments->first_case, "Seed of the first case")
      .check(number_from(std::uint64_t{0}, kLargestFirstCase))
      .show_default();
  command.add_flag("--json", arguments->json, "Print JSON (coapt.training_raters/1)");
  command.footer(
      "Example:\n"
      "  coapt train raters human-normal --cases 50");
  command.on_run([arguments, &status] { status = run(*arguments); });
}

}  // namespace coapt
