#include "operations/valve_operations.h"

#include <array>

#include "operations/table.h"

namespace coapt {
namespace {

using namespace door;

constexpr unsigned kTrainer = kCommandLine | kBrowser;

constexpr std::array kOperations = {
    Operation{"close", "close", "/v1/closures", "Closes a valve and measures what leaks.",
              kEverywhere, read_close},
    Operation{"scene", "", "/v1/scenes", "Closes a valve and gives all that is drawn of it.",
              kService | kPython | kBrowser, read_scene},
    Operation{"open", "open", "/v1/openings",
              "Opens a valve as in diastole and measures its opening.", kEverywhere, read_open},
    Operation{"diagnose", "diagnose", "/v1/diagnoses",
              "Says why a valve leaks, segment by segment.", kEverywhere, read_diagnose},
    Operation{"information", "study information", "/v1/information",
              "Says which measurement of a valve would tell most of its leak.", kEverywhere,
              read_information},
    Operation{"observe", "observe", "/v1/valves:observe",
              "Keeps with a valve what images show of it.", kEverywhere, read_observe},
    Operation{"check", "valve check", "/v1/valves:validate",
              "Lists every problem of a valve document.", kEverywhere, read_check},
    Operation{"training_case", "", "/v1/training/cases",
              "Makes a case of valve analysis from a seed.", kBrowser, read_training_case},
    Operation{"training_exam", "train exam", "/v1/training/exams", "Draws the exam of a schedule.",
              kTrainer, read_training_exam},
    Operation{"training_score", "train score", "/v1/training/scores",
              "Scores the trials of a learner.", kTrainer, read_training_score}};

}  // namespace

std::span<const Operation> valve_operations() { return kOperations; }

}  // namespace coapt
