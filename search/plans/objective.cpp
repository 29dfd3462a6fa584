#include "search/plans/objective.h"

#include <algorithm>
#include <cmath>

#include "core/repair/limits.h"

namespace coapt {
namespace {

/// NaN if either is.
double excess(double value, double limit) {
  const double over = value - limit;
  return over <= 0.0 ? 0.0 : over;
}

}  // namespace

CostTerms effort_terms(const Effort& effort) {
  CostTerms terms;
  terms[CostTerm::Step] = effort.steps;
  terms[CostTerm::Undersizing] = effort.sizes_below;
  terms[CostTerm::UndersizingAbove4] = excess(effort.sizes_below, kMostSizesBelow);
  for (const double movement :
       {effort.anterolateral_movement_mm, effort.posteromedial_movement_mm}) {
    terms[CostTerm::Movement] += movement;
    terms[CostTerm::MovementAbove10] += excess(movement, kUsualMovement_mm);
  }
  return terms;
}

double effort_price(const Effort& effort, const CostWeights& weights) {
  return price(effort_terms(effort), weights);
}

double movement_price(double movement_mm, const CostWeights& weights) {
  return effort_price({.anterolateral_movement_mm = movement_mm}, weights);
}

CostTerms cost_terms(std::span<const ScoredClosure> closures, const Effort& effort,
                     const CostContext& context) {
  double leaks = 0.0, squares = 0.0, coaptation = 0.0, gap = 0.0, tension = 0.0, first_leak = 1.0;
  int counted = 0;
  for (const auto& [closure, disturbance] : closures) {
    if (!trusted(closure)) continue;
    const double leak = closure.leak_mm2;
    const double short_by = excess(kCoaptationAim_mm, closure.coaptation_mm);
    const double apart = excess(closure.distance_max_mm, context.thickness_mm);
    const double pull = excess(closure.tension_max_n, context.tension_before_n);
    if (!std::isfinite(short_by + apart + pull)) continue;  // counts as not trusted
    ++counted;
    leaks += leak;
    squares += leak * leak;
    coaptation += short_by;
    gap += apart;
    tension += pull;
    if (leak > kTraceLeak_mm2) first_leak = std::min(first_leak, disturbance);
  }
  CostTerms terms = effort_terms(effort);
  const double asked = closures.empty() ? 1.0 : static_cast<double>(closures.size());
  terms[CostTerm::Untrusted] = 1.0 - counted / asked + (counted == 0 ? 1.0 : 0.0);
  if (counted == 0) return terms;
  const double mean = leaks / counted;
  const double sd = std::sqrt(std::max(0.0, squares / counted - mean * mean));
  terms[CostTerm::Leak] = mean + context.weights.sd_share * sd;
  terms[CostTerm::Incompetence] = excess(terms[CostTerm::Leak], kTraceLeak_mm2);
  terms[CostTerm::Margin] = 1.0 - first_leak;
  terms[CostTerm::Coaptation] = coaptation / counted;
  terms[CostTerm::Gap] = gap / counted;
  terms[CostTerm::Tension] = tension / counted;
  return terms;
}

double plan_cost(std::span<const ScoredClosure> closures, const Effort& effort,
                 const CostContext& context) {
  return price(cost_terms(closures, effort, context), context.weights);
}

}  // namespace coapt
