// The next pair of plans to compare, and what the comparisons so far say of the weights. Answers coapt.preference/1.
#include <algorithm>

#include "io/json/answers_json.h"
#include "io/json/preference_json.h"
#include "operations/table.h"

namespace coapt {
namespace {

constexpr std::size_t kMostCases = 20, kMostPlans = 50, kMostAnswers = 1000, kLongestCaseName = 200;

/// Says so where there are more.
template <class List>
void check_count(const JsonPlace& place, const List& list, std::size_t least, std::size_t most) {
  if (list.size() < least || list.size() > most)
    add_problem(place, ErrorCode::OutOfRange,
                "has " + std::to_string(list.size()) + ", must have " + std::to_string(least) +
                    " to " + std::to_string(most));
}

PlanCase read_named_case(const JsonPlace& place) {
  PlanCase read = read_plan_case(place);
  if (const auto name = read_member(place, "name")) {
    read.name = read_string(*name);
    check_count(*name, read.name, 1, kLongestCaseName);
  }
  if (const auto plans = place.value.find("plans"); plans != place.value.end())
    check_count({*plans, place.problems, &place, "plans"}, read.plans, 0, kMostPlans);
  return read;
}

std::vector<PlanCase> read_cases_of_plans(const JsonPlace& place) {
  std::vector<PlanCase> cases = read_list(place, read_named_case);
  check_count(place, cases, 1, kMostCases);
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const auto said = std::find_if(cases.begin(), cases.begin() + static_cast<std::ptrdiff_t>(i),
                                   [&](const PlanCase& of) { return of.name == cases[i].name; });
    if (said != cases.begin() + static_cast<std::ptrdiff_t>(i))
      add_problem(place, ErrorCode::BadReference, "two cases are named \"" + cases[i].name + '"');
    if (cases[i].sd_share != cases.front().sd_share)
      add_problem(place, ErrorCode::OutOfRange, "weights/sd_share must be the same for all cases");
  }
  return cases;
}

struct PreferRequest {
  std::vector<PlanCase> cases{};
  std::vector<GivenAnswer> answers{};
  bool hide_figures = false;
};

Expected<OperationAnswer> learn(const PreferRequest& asked, Context& /*context*/) {
  const PreferencePosterior posterior = posterior_of(asked.cases, asked.answers);
  const PosteriorDraws draws = draw(posterior);
  Json json = {{"schema", "coapt.preference/1"},
               {"question", nullptr},
               {"first_places", first_places_to_json(asked.cases, draws)},
               {"learned", learned_to_json(asked.cases, asked.answers, posterior)}};
  if (const auto question = next_question(asked.cases, asked.answers, draws))
    json["question"] = to_json(*question, asked.cases, asked.hide_figures);
  return OperationAnswer(std::move(json));
}

}  // namespace

Expected<OperationTask> read_prefer(const Json& request, const Context& /*context*/) {
  PreferRequest asked;
  const auto read_all_answers = [&asked](const JsonPlace& place) {
    // Else they name nothing.
    if (place.problems.empty()) asked.answers = read_answers(place, asked.cases);
    check_count(place, asked.answers, 0, kMostAnswers);
  };
  ProblemList problems;
  read_fields({request, problems},
              {{"cases", into(asked.cases, read_cases_of_plans)},
               {"answers", read_all_answers},
               {"hide_figures", into(asked.hide_figures, read_boolean), false}});
  if (!problems.empty()) return std::move(problems).take();
  return OperationTask{0, 1, [asked](Context& context) { return learn(asked, context); }};
}

}  // namespace coapt
