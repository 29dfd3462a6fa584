#include <algorithm>
#include <array>

#include "operations/table.h"

namespace coapt {

std::span<const Operation> valve_operations() {
  static constexpr std::array kOperations = {
      Operation{"close", "/v1/closures", "Closes a valve and measures what leaks.", read_close},
      Operation{"scene", "/v1/scenes", "Closes a valve and gives all that is drawn of it.",
                read_scene},
      Operation{"open", "/v1/openings", "Opens a valve as in diastole and measures its opening.",
                read_open},
      Operation{"diagnose", "/v1/diagnoses", "Says why a valve leaks, segment by segment.",
                read_diagnose},
      Operation{"check", "/v1/valves:validate", "Lists every problem of a valve document.",
                read_check},
      Operation{"training case", "/v1/training/cases",
                "Makes a case of valve analysis from a seed.", read_training_case},
      Operation{"training exam", "/v1/training/exams", "Draws the exam of a schedule.",
                read_training_exam},
      Operation{"training score", "/v1/training/scores", "Scores the trials of a learner.",
                read_training_score}};
  return kOperations;
}

const Operation* operation_at(std::span<const Operation> among, std::string_view path) {
  const auto found = std::find_if(among.begin(), among.end(),
                                  [&](const Operation& one) { return path == one.path; });
  return found == among.end() ? nullptr : &*found;
}

}  // namespace coapt
