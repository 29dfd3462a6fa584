// Experts whose weights are known, to judge what is learned from their answers.
#pragma once

#include <random>

#include "search/preference/posterior.h"

namespace coapt {

enum class ExpertNoise {
  Model,  ///< answers as answer_model.h has it, noise and tie drawn from their priors
  Flips   ///< sure of every answer, and wrong in one of ten: not what the model assumes
};
const char* to_string(ExpertNoise noise);

inline constexpr double kFlippedShare = 0.1;

struct SimulatedExpert {
  ExpertNoise noise = ExpertNoise::Model;
  Unknowns truth = Unknowns::Zero();  ///< logarithms; of ExpertNoise::Flips the weights alone count
};

/// From the prior.
SimulatedExpert drawn_expert(ExpertNoise noise, std::mt19937_64& engine);

/// @param difference first less second
Preference answer(const SimulatedExpert& expert, const CostTerms& difference,
                  std::mt19937_64& engine);

/// By how much the plan that `weights` rank first costs more than the best one, mm2 by the expert's weights.
double regret_mm2(const PlanCase& plans, const CostWeights& weights, const CostWeights& expert);

}  // namespace coapt
