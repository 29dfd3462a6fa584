// What trials say, as JSON: coapt.training_score/1.
#pragma once

#include <cstddef>
#include <vector>

#include "io/json/json.h"
#include "search/training/training_trial.h"

namespace coapt {

/// Fewer learners do not calibrate the difficulty of cases.
inline constexpr int kCalibrationLearners = 10;

/// First answers to exam A's cases that calibrate, in the order of the table; later ones do not count. The time of calibration is
/// proportional to them: some seconds for so many.
inline constexpr std::size_t kMostCalibrationAnswers = 10'000;

/// "scores": of each learner and exam over all blocks (block null) and by block; "next" of each learner and exam: the difficulty that
/// they get right with probability 0.6, and the cases to repeat; "cases": calibrated difficulties where at least
/// kCalibrationLearners did exam A. @pre each learner's trials are in their order.
Json score_to_json(const std::vector<TrainingTrial>& trials);

}  // namespace coapt
