// Plans to compare, and an expert's answers (coapt.answers/1), as JSON.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "io/json/json.h"
#include "io/json/json_reader.h"
#include "search/preference/question.h"

namespace coapt {

/// The plans of a coapt.plans/2; what else it holds is not looked at. The case has no name yet.
Expected<PlanCase> read_plan_case(std::string_view text);
PlanCase read_plan_case(const JsonPlace& place);

struct AnswerSheet {
  std::string rater;
  std::vector<GivenAnswer> answers;
};

/// {"schema", "rater", "answers": [{"case", "first", "second", "answer"}]}: cases by name, plans by rank, answers "first",
/// "second" or "unable". Errors: cases and plans that are not among `cases`, too.
Expected<AnswerSheet> read_answers(std::string_view text, const std::vector<PlanCase>& cases);
/// Those in that list.
std::vector<GivenAnswer> read_answers(const JsonPlace& place, const std::vector<PlanCase>& cases);

Json to_json(const AnswerSheet& sheet, const std::vector<PlanCase>& cases);

/// {"case", "first", "second", "repeats", "information_bits", "plans": [...]}: what is asked with its two plans, the first
/// one first; figures that are not known are null, hidden ones left out.
Json to_json(const Question& question, const std::vector<PlanCase>& cases, bool hide_figures);

}  // namespace coapt
