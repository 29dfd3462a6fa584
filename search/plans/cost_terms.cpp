#include "search/plans/cost_terms.h"

namespace coapt {

const std::array<CostTermRow, kTerms>& cost_term_rows() {
  static constexpr std::array<CostTermRow, kTerms> kRows = {
      {{"step", &CostWeights::step},
       {"undersizing", &CostWeights::undersizing},
       {"undersizing_above_4", &CostWeights::undersizing_above_4},
       {"movement", &CostWeights::movement},
       {"movement_above_10", &CostWeights::movement_above_10},
       {"leak", &CostWeights::leak},
       {"incompetence", &CostWeights::incompetence},
       {"margin", &CostWeights::margin},
       {"coaptation", &CostWeights::coaptation},
       {"gap", &CostWeights::gap},
       {"tension", &CostWeights::tension},
       {"gradient_above_3", &CostWeights::gradient_above_3},
       {"gradient_above_5", &CostWeights::gradient_above_5},
       {"durability", &CostWeights::durability},
       {"untrusted", &CostWeights::untrusted}}};
  return kRows;
}

double price(const CostTerms& terms, const CostWeights& weights) {
  double sum = 0.0;
  for (int term = 0; term < kTerms; ++term)
    sum += weights.*cost_term_rows()[term].weight * terms.amounts[term];
  return sum;
}

}  // namespace coapt
