// Small cases of plans that differ in one or two terms.
#pragma once

#include <utility>
#include <vector>

#include "search/preference/comparison.h"

namespace coapt {

inline ComparedPlan plan_with(std::initializer_list<std::pair<CostTerm, double>> amounts) {
  ComparedPlan plan;
  for (const auto& [term, amount] : amounts) plan.terms[term] = amount;
  return plan;
}

inline CostTerms terms_with(std::initializer_list<std::pair<CostTerm, double>> amounts) {
  return plan_with(amounts).terms;
}

}  // namespace coapt
