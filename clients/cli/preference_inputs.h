// What `coapt prefer` reads and keeps: the plans of cases, and a rater's answers on them.
#pragma once

#include <string>
#include <vector>

#include "io/json/answers_json.h"

namespace coapt {

struct PreferenceCases {
  int failed = 0;                  ///< exit code; then the rest is empty
  std::vector<PlanCase> cases;     ///< each named by its plans
  std::vector<std::string> files;  ///< of each
};

/// Says on standard error what is wrong with a file; also files that hold the same plans, or leaks counted with another sd_share
/// than those of the others.
PreferenceCases read_cases(const std::vector<std::string>& paths);

struct AnswersFile {
  int failed = 0;  ///< exit code
  AnswerSheet sheet;
};

/// No answers where the file does not exist. @param rater of a new file; of an old one it must be the same, unless empty.
AnswersFile read_answers_file(const std::string& path, const std::vector<PlanCase>& cases,
                              const std::string& rater);

/// In place of what was there at once, so that a crash loses no earlier answer. Returns an exit code.
int write_answers_file(const std::string& path, const AnswerSheet& sheet,
                       const std::vector<PlanCase>& cases);

}  // namespace coapt
