#include "lab/preference/simulated_expert.h"

#include <algorithm>
#include <cmath>

#include "search/random_share.h"

namespace coapt {

const char* to_string(ExpertNoise noise) { return noise == ExpertNoise::Model ? "model" : "flips"; }

SimulatedExpert drawn_expert(ExpertNoise noise, std::mt19937_64& engine) {
  SimulatedExpert expert{noise, prior_mean({})};
  const Unknowns sd = prior_sd({});
  for (int i = 0; i < kUnknowns; ++i) expert.truth[i] += sd[i] * normal_share(engine);
  return expert;
}

Preference answer(const SimulatedExpert& expert, const CostTerms& difference,
                  std::mt19937_64& engine) {
  const double lead = advantage(difference, expert.truth), share = random_share(engine);
  if (expert.noise == ExpertNoise::Flips)
    return (lead > 0.0) == (share >= kFlippedShare) ? Preference::First : Preference::Second;
  const AnswerShares shares = answer_shares(lead, std::exp(expert.truth[kTie]));
  if (share < shares.first) return Preference::First;
  return share < shares.first + shares.second ? Preference::Second : Preference::Unable;
}

double regret_mm2(const PlanCase& plans, const CostWeights& weights, const CostWeights& expert) {
  const auto cheapest = [&](const CostWeights& by) {
    return std::min_element(plans.plans.begin(), plans.plans.end(),
                            [&](const ComparedPlan& a, const ComparedPlan& b) {
                              return price(a.terms, by) < price(b.terms, by);
                            });
  };
  return price(cheapest(weights)->terms, expert) - price(cheapest(expert)->terms, expert);
}

}  // namespace coapt
