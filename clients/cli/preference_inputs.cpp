#include "clients/cli/preference_inputs.h"

#include <algorithm>
#include <filesystem>
#include <iostream>

#include "core/valve/printable.h"
#include "io/command_line/exit_code.h"
#include "io/command_line/files.h"
#include "io/json/subject.h"

namespace coapt {
namespace {

constexpr std::size_t kNameDigits = 16;

/// Of what is compared: plans of another search of the same valve are another case.
std::string name_of_plans(const PlanCase& plans) {
  std::string amounts;
  for (const ComparedPlan& plan : plans.plans)
    amounts +=
        Json(std::vector<double>(plan.terms.amounts.begin(), plan.terms.amounts.end())).dump();
  return fnv1a_128(amounts).substr(0, kNameDigits);
}

/// What speaks against a case beside those before it.
Errors conflicts(const PlanCase& plans, const PreferenceCases& before) {
  for (std::size_t i = 0; i < before.cases.size(); ++i) {
    if (plans.name == before.cases[i].name)
      return {{ErrorCode::BadReference, "/plans", "are those of " + before.files[i]}};
    if (plans.sd_share != before.cases[i].sd_share)
      return {{ErrorCode::OutOfRange, "/weights/sd_share",
               "is not that of " + before.files[i] + ", must be the same for all"}};
  }
  return {};
}

}  // namespace

PreferenceCases read_cases(const std::vector<std::string>& paths) {
  PreferenceCases all;
  for (const std::string& path : paths) {
    const Expected<std::string> text = read_input(path);
    Expected<PlanCase> read = text ? read_plan_case(*text) : Expected<PlanCase>(text.errors());
    if (!read) {
      all.failed = report_errors(path, read.errors());
      continue;
    }
    read->name = name_of_plans(*read);
    if (const Errors problems = conflicts(*read, all); !problems.empty())
      all.failed = report_errors(path, problems);
    all.cases.push_back(*read);
    all.files.push_back(path);
  }
  return all.failed ? PreferenceCases{all.failed, {}, {}} : all;
}

AnswersFile read_answers_file(const std::string& path, const std::vector<PlanCase>& cases,
                              const std::string& rater) {
  std::error_code ignored;
  if (!std::filesystem::exists(path, ignored)) return {exit_code::kOk, {rater, {}}};
  const Expected<std::string> text = read_input(path);
  if (!text) return {report_errors(path, text.errors()), {}};
  const Expected<AnswerSheet> sheet = read_answers(*text, cases);
  if (!sheet) return {report_errors(path, sheet.errors()), {}};
  if (!rater.empty() && rater != sheet->rater) {
    const Error other{ErrorCode::BadReference, "/rater",
                      "is \"" + sheet->rater + "\", which differs from --rater \"" + rater + '"'};
    return {report_errors(path, {other}), {}};
  }
  return {exit_code::kOk, *sheet};
}

int write_answers_file(const std::string& path, const AnswerSheet& sheet,
                       const std::vector<PlanCase>& cases) {
  const std::string part = path + ".part";
  if (const int failed = write_output(part, to_json(sheet, cases).dump(1) + '\n')) return failed;
  std::error_code failed;
  std::filesystem::rename(part, path, failed);
  if (!failed) return exit_code::kOk;
  std::cerr << "coapt: " << printable(path) << ": cannot be written\n";
  return exit_code::kFailure;
}

}  // namespace coapt
