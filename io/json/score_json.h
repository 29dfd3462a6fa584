// What trials say, as JSON: coapt.training_score/1.
#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "search/training/training_trial.h"

namespace coapt {

/// Fewer learners do not calibrate the difficulty of cases.
inline constexpr int kCalibrationLearners = 10;

/// "scores": of each learner and exam over all blocks (block null) and by block; "next" of each learner and exam: the difficulty that
/// they get right with probability 0.6, and the cases to repeat; "cases": calibrated difficulties where at least
/// kCalibrationLearners did exam A. @pre each learner's trials are in their order.
nlohmann::ordered_json score_to_json(const std::vector<TrainingTrial>& trials);

}  // namespace coapt
