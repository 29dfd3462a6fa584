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
    Operation{"scene", "", "/v1/scenes", "Closes a valve and returns all data for drawing it.",
              kService | kPython | kBrowser, read_scene},
    Operation{"open", "open", "/v1/openings", "Opens a valve in diastole and measures its opening.",
              kEverywhere, read_open},
    Operation{"diagnose", "diagnose", "/v1/diagnoses",
              "Finds why a valve leaks, segment by segment.", kEverywhere, read_diagnose},
    Operation{"compare", "compare", "/v1/comparisons",
              "Measures the distance between a closed valve and an image or the result of another "
              "program.",
              kEverywhere, read_compare},
    Operation{"information", "study information", "/v1/information",
              "Ranks measurements by how much they would reduce the tissue error of the leak.",
              kEverywhere, read_information},
    Operation{"observe", "observe", "/v1/valves:observe",
              "Stores observations from images with a valve.", kEverywhere, read_observe},
    Operation{"check", "valve check", "/v1/valves:validate",
              "Lists every problem of a valve document.", kEverywhere, read_check},
    Operation{"training_case", "", "/v1/training/cases",
              "Makes a case for valve analysis training.", kBrowser, read_training_case},
    Operation{"training_exam", "train exam", "/v1/training/exams",
              "Generates the trials of an exam schedule.", kTrainer, read_training_exam},
    Operation{"training_score", "train score", "/v1/training/scores",
              "Scores the trials of a learner.", kTrainer, read_training_score}};

}  // namespace

std::span<const Operation> valve_operations() { return kOperations; }

}  // namespace coapt
