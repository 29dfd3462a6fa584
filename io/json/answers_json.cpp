#include "io/json/answers_json.h"

#include <cmath>
#include <limits>

#include "io/json/json_reader.h"
#include "io/json/parse_json.h"

namespace coapt {
namespace {

constexpr Range kAmounts = {-1e9, 1e9};  // a finer mesh may take from a leak

/// NaN where it is null.
double read_figure(const JsonPlace& place) {
  return place.value.is_null() ? std::numeric_limits<double>::quiet_NaN() : read_number(place);
}

/// A member of an object that may have others.
void read_one(const JsonPlace& place, std::string_view name,
              const std::function<void(const JsonPlace&)>& read) {
  if (const std::optional<JsonPlace> found = read_member(place, name)) read(*found);
}

void read_if_there(const JsonPlace& place, std::string_view name,
                   const std::function<void(const JsonPlace&)>& read) {
  if (place.value.is_object() && place.value.contains(name)) read_one(place, name, read);
}

CostTerms read_cost_terms(const JsonPlace& place) {
  CostTerms terms;
  std::vector<JsonField> fields;
  for (int term = 0; term < kTerms; ++term)
    fields.push_back({cost_term_rows()[static_cast<std::size_t>(term)].name,
                      into(terms.amounts[term],
                           [](const JsonPlace& at) { return read_number_in(at, kAmounts); })});
  read_fields(place, fields);
  return terms;
}

ComparedPlan read_compared_plan(const JsonPlace& place) {
  ComparedPlan plan;
  read_one(place, "cost_terms", into(plan.terms, read_cost_terms));
  read_one(place, "description",
           [&](const JsonPlace& at) { plan.description = read_list(at, read_string); });
  read_if_there(place, "leak_mm2", [&](const JsonPlace& at) {
    read_one(at, "mean", into(plan.leak_mm2, read_figure));
  });
  read_if_there(place, "opening_area_mm2", into(plan.opening_area_mm2, read_figure));
  read_if_there(place, "durability_mm", into(plan.durability_mm, read_figure));
  return plan;
}

GivenAnswer read_answer(const JsonPlace& place, const std::vector<PlanCase>& cases) {
  int plans = std::numeric_limits<int>::max();  // of the case
  int first = 0, second = 0;
  GivenAnswer given;
  const auto read_case = [&](const JsonPlace& at) {
    std::vector<std::string> names;
    for (const PlanCase& of : cases) names.push_back(of.name);
    const std::optional<std::size_t> found = read_choice(at, names);
    if (!found) return;
    given.pair.of_case = static_cast<int>(*found);
    plans = static_cast<int>(cases[*found].plans.size());
  };
  const auto read_rank = [&](const JsonPlace& at) { return read_integer_in(at, 1, plans); };
  const auto read_choice_of = [](const JsonPlace& at) {
    return read_name(at, std::vector{Preference::First, Preference::Second, Preference::Unable});
  };
  read_fields(place, {{"case", read_case},
                      {"first", into(first, read_rank)},
                      {"second", into(second, read_rank)},
                      {"answer", into(given.answer, read_choice_of)}});
  if (first > 0 && first == second)
    add_problem(place, ErrorCode::OutOfRange,
                "compares plan " + std::to_string(first) + " with itself, must be two plans");
  if (first > 0) given.pair.first = first - 1;
  if (second > 0) given.pair.second = second - 1;
  return given;
}

Json figure_json(double value) { return std::isfinite(value) ? Json(value) : Json(); }

Json pair_json(const PlanPair& pair, const std::vector<PlanCase>& cases) {
  return {{"case", cases[static_cast<std::size_t>(pair.of_case)].name},
          {"first", pair.first + 1},
          {"second", pair.second + 1}};
}

Json compared_json(const ComparedPlan& plan, int rank, bool hide_figures) {
  Json json = {{"rank", rank}, {"description", plan.description}};
  if (hide_figures) return json;
  json.update({{"leak_mm2", figure_json(plan.leak_mm2)},
               {"opening_area_mm2", figure_json(plan.opening_area_mm2)},
               {"durability_mm", figure_json(plan.durability_mm)}});
  return json;
}

}  // namespace

PlanCase read_plan_case(const JsonPlace& place) {
  PlanCase read;
  read_one(place, "schema",
           [](const JsonPlace& at) { read_schema(at, "coapt.plans/2", "coapt.plans/1"); });
  read_one(place, "plans",
           [&](const JsonPlace& at) { read.plans = read_list(at, read_compared_plan); });
  read_if_there(place, "weights", [&](const JsonPlace& at) {
    read_one(at, "sd_share", into(read.sd_share, read_number));
  });
  return read;
}

Expected<PlanCase> read_plan_case(std::string_view text) {
  const Expected<Json> json = parse_json(text);
  if (!json) return json.errors();
  ProblemList problems;
  PlanCase read = read_plan_case(JsonPlace{*json, problems});
  if (!problems.empty()) return std::move(problems).take();
  return read;
}

std::vector<GivenAnswer> read_answers(const JsonPlace& place, const std::vector<PlanCase>& cases) {
  return read_list(place, [&](const JsonPlace& entry) { return read_answer(entry, cases); });
}

Expected<AnswerSheet> read_answers(std::string_view text, const std::vector<PlanCase>& cases) {
  const Expected<Json> json = parse_json(text);
  if (!json) return json.errors();
  ProblemList problems;
  AnswerSheet sheet;
  read_fields({*json, problems},
              {{"schema", [](const JsonPlace& at) { read_schema(at, "coapt.answers/1"); }},
               {"rater", into(sheet.rater, read_string)},
               {"answers", [&](const JsonPlace& at) { sheet.answers = read_answers(at, cases); }}});
  if (!problems.empty()) return std::move(problems).take();
  return sheet;
}

Json to_json(const AnswerSheet& sheet, const std::vector<PlanCase>& cases) {
  Json answers = Json::array();
  for (const GivenAnswer& given : sheet.answers) {
    Json entry = pair_json(given.pair, cases);
    entry["answer"] = to_string(given.answer);
    answers.push_back(std::move(entry));
  }
  return {{"schema", "coapt.answers/1"}, {"rater", sheet.rater}, {"answers", answers}};
}

Json to_json(const Question& question, const std::vector<PlanCase>& cases, bool hide_figures) {
  Json json = pair_json(question.pair, cases), plans = Json::array();
  json["repeats"] = question.repeats;
  json["information_bits"] = question.information_bits;
  const auto& all = cases[static_cast<std::size_t>(question.pair.of_case)].plans;
  for (const int plan : {question.pair.first, question.pair.second})
    plans.push_back(compared_json(all[static_cast<std::size_t>(plan)], plan + 1, hide_figures));
  json["plans"] = std::move(plans);
  return json;
}

}  // namespace coapt
