#include "search/plans/objective.h"

#include <algorithm>
#include <cmath>

#include "core/repair/limits.h"
#include "core/valve/annulus_frame.h"

namespace coapt {
namespace {

constexpr double kHealthyProportion =
    0.75;  // AP over transverse: 29 / 39 (PMC7368231), classic rings

double movement_mm(const Valve& before, const Valve& repaired, Side side) {
  for (std::size_t h = 0; h < before.heads.size(); ++h)
    if (before.heads[h].side == side)
      return (repaired.heads[h].tip_mm - before.heads[h].tip_mm).norm();
  return 0.0;
}

/// NaN if either is.
double excess(double value, double limit) {
  const double over = value - limit;
  return over <= 0.0 ? 0.0 : over;
}

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

double effort_price(const Effort& effort, const CostWeights& weights) {
  double sum = weights.step * effort.steps + weights.undersizing * effort.sizes_below +
               weights.undersizing_above_4 * excess(effort.sizes_below, kMostSizesBelow);
  for (const double movement : {effort.anterolateral_movement_mm, effort.posteromedial_movement_mm})
    sum += movement_price(movement, weights);
  return sum;
}

double plan_cost(std::span<const ScoredClosure> closures, const Effort& effort,
                 const CostContext& context) {
  const CostWeights& weights = context.weights;
  double leaks = 0.0, squares = 0.0, slopes = 0.0, first_leak = 1.0;
  int counted = 0;
  for (const auto& [closure, disturbance] : closures) {
    if (!trusted(closure)) continue;
    const double leak = leak_mm2(closure);
    const double slope = weights.coaptation * excess(kCoaptationAim_mm, closure.coaptation_mm) +
                         weights.gap * excess(closure.distance_max_mm, context.thickness_mm) +
                         weights.tension * excess(closure.tension_max_n, context.tension_before_n);
    if (!std::isfinite(slope)) continue;  // counts as not trusted
    ++counted;
    leaks += leak;
    squares += leak * leak;
    slopes += slope;
    if (leak > kCompetentLeak_mm2) first_leak = std::min(first_leak, disturbance);
  }
  const double asked = closures.empty() ? 1.0 : static_cast<double>(closures.size());
  const double failed = 1.0 - counted / asked;
  double sum = effort_price(effort, weights) + weights.untrusted * failed;
  if (counted == 0) return sum + weights.untrusted;
  const double mean = leaks / counted;
  const double sd = std::sqrt(std::max(0.0, squares / counted - mean * mean));
  const double robust = mean + weights.sd_share * sd;
  return sum + weights.leak * robust + weights.incompetence * excess(robust, kCompetentLeak_mm2) +
         weights.margin * (1.0 - first_leak) + slopes / counted;
}

}  // namespace coapt
