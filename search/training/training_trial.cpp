#include "search/training/training_trial.h"

#include <algorithm>

#include "search/training/exam_a.h"

namespace coapt {

std::vector<Response> responses_of(const TrainingTrial& trial) {
  std::vector<Response> responses;
  if (const auto* chosen = std::get_if<ChosenValve>(&trial.judged)) {
    responses.push_back({chosen->choice == chosen->answer, trial.difficulty, kChanceA});
  } else {
    const auto& judged = std::get<JudgedSegments>(trial.judged);
    for (std::size_t s = 0; s < kSegments; ++s)
      responses.push_back({judged.choice[s] == judged.answer[s], trial.difficulty, kChanceB});
  }
  return responses;
}

int answers_of(const TrainingTrial& trial) {
  return std::holds_alternative<ChosenValve>(trial.judged) ? 1 : static_cast<int>(kSegments);
}

int right_of(const TrainingTrial& trial) {
  const std::vector<Response> responses = responses_of(trial);
  return static_cast<int>(std::count_if(responses.begin(), responses.end(),
                                        [](const Response& response) { return response.right; }));
}

double chance_of(const TrainingTrial& trial) {
  return std::holds_alternative<ChosenValve>(trial.judged) ? kChanceA : kChanceB;
}

}  // namespace coapt
