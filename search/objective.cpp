#include "search/objective.h"

#include <algorithm>
#include <cmath>

#include "core/repair/limits.h"
#include "core/valve/annulus_frame.h"

namespace coapt {
namespace {

constexpr double kCoaptationAim_mm = 8.0;  // an aim of surgeons, evidence is weak
constexpr double kHealthyProportion =
    0.75;  // AP over transverse: 29 / 39 (PMC7368231), classic rings

double movement_mm(const Valve& before, const Valve& repaired, Side side) {
  for (std::size_t h = 0; h < before.heads.size(); ++h)
    if (before.heads[h].side == side)
      return (repaired.heads[h].tip_mm - before.heads[h].tip_mm).norm();
  return 0.0;
}

/// Mean of the three middle sections of nine: where surgeons measure, between A2 and P2.
double central_coaptation_mm(const Coaptation& coaptation) {
  const auto& sections = coaptation.sections;
  return (sections[3].height_mm + sections[4].height_mm + sections[5].height_mm) / 3.0;
}

double excess(double value, double limit) { return std::max(0.0, value - limit); }

}  // namespace

double movement_price(double movement_mm, const CostWeights& weights) {
  return weights.movement * movement_mm +
         weights.movement_above_10 * excess(movement_mm, kUsualMovement_mm);
}

double ring_sizes_below(const Valve& before, const Valve& repaired) {
  const AnnulusFrame native = annulus_frame(before), ringed = annulus_frame(repaired);
  const double width = transverse_diameter_mm(before, native);
  const double share = ap_diameter_mm(repaired, ringed) * transverse_diameter_mm(repaired, ringed) /
                       (kHealthyProportion * width * width);
  return excess((1.0 - std::sqrt(share)) * width, 0.0) / kRingSizeStep_mm;
}

Effort effort(const Valve& before, const Valve& repaired, const RepairPlan& plan) {
  const bool ring = repaired.annulus_mm != before.annulus_mm;
  return {movement_mm(before, repaired, Side::Anterolateral),
          movement_mm(before, repaired, Side::Posteromedial),
          ring ? ring_sizes_below(before, repaired) : 0.0, static_cast<int>(plan.steps.size())};
}

double cost(const Evaluation& evaluation, const Effort& effort, double thickness_mm,
            double tension_before_n, const CostWeights& weights) {
  double sum = weights.step * effort.steps + weights.undersizing * effort.sizes_below +
               weights.undersizing_above_4 * excess(effort.sizes_below, kMostSizesBelow);
  for (const double movement : {effort.anterolateral_movement_mm, effort.posteromedial_movement_mm})
    sum += movement_price(movement, weights);
  if (!trusted(evaluation)) sum += weights.untrusted;
  const ValveMeasure& measure = evaluation.measure;
  const double leak = leak_mm2(measure);
  const double closed =
      weights.leak * leak + weights.leak_above_5 * excess(leak, kGoodRepair_mm2) +
      weights.coaptation * excess(kCoaptationAim_mm, central_coaptation_mm(measure.coaptation)) +
      weights.gap * excess(measure.coaptation.distance_max_mm, thickness_mm) +
      weights.tension * excess(measure.tension_max_n, tension_before_n);
  // A valve that flew apart has no measures; it is not trusted either, and worse than any that has.
  return sum + (std::isfinite(closed) ? closed : weights.untrusted);
}

}  // namespace coapt
