#include "search/rings/ring_cost.h"

#include <algorithm>
#include <cmath>

#include "core/repair/limits.h"
#include "search/plans/durability.h"
#include "search/plans/objective.h"
#include "search/plans/plan_opening.h"

namespace coapt {
namespace {

constexpr double kLeakScale_mm2 = 1.5, kGradientScale_mmhg = 0.3, kSizesScale = 0.1;
constexpr double kImpossible = 3.0;  // more than a ring that leaks, is narrow and undersized

/// 1 far above the limit, 0 far below.
double above(double value, double limit, double scale) {
  return 1.0 / (1.0 + std::exp((limit - value) / scale));
}

double counted_leak(double leak_mm2) {
  return std::isfinite(leak_mm2) ? std::min(leak_mm2, kMostLeak_mm2) : kMostLeak_mm2;
}

}  // namespace

double smooth_share_below(double leak_mm2) {
  return std::isfinite(leak_mm2) ? 1.0 - above(leak_mm2, kMildLeak_mm2, kLeakScale_mm2) : 0.0;
}

double ring_cost(const RingOutcome& outcome, const RingWeights& weights) {
  if (!outcome.is_possible) return kImpossible;
  double leaking = 0.0;
  for (const double leak : outcome.leaks_mm2) leaking += 1.0 - smooth_share_below(leak);
  double cost = leaking / static_cast<double>(outcome.leaks_mm2.size()) +
                weights.leak_per_mm2 * mean_leak_mm2(outcome) +
                weights.undersized *
                    above(outcome.sizes_below, kMostSizesBelow + 2.0 * kSizesScale, kSizesScale);
  if (std::isfinite(outcome.gradient_mmhg))
    cost += weights.narrow * above(outcome.gradient_mmhg, kStenosis_mmhg, kGradientScale_mmhg);
  if (std::isfinite(outcome.suture_max_n)) cost += weights.suture_per_n * outcome.suture_max_n;
  if (std::isfinite(outcome.durability_mm))
    cost += weights.durability_per_mm * (kFurthestCourse_mm - outcome.durability_mm);
  return cost;
}

double ring_cost(const std::vector<RingOutcome>& outcomes, const RingWeights& weights) {
  double sum = 0.0;
  for (const RingOutcome& outcome : outcomes) sum += ring_cost(outcome, weights);
  return sum / static_cast<double>(outcomes.size());
}

double share_below(const RingOutcome& outcome) {
  if (outcome.leaks_mm2.empty()) return 0.0;
  const auto below = std::count_if(outcome.leaks_mm2.begin(), outcome.leaks_mm2.end(),
                                   [](double leak) { return leak < kMildLeak_mm2; });
  return static_cast<double>(below) / static_cast<double>(outcome.leaks_mm2.size());
}

double mean_leak_mm2(const RingOutcome& outcome) {
  if (outcome.leaks_mm2.empty()) return kMostLeak_mm2;
  double sum = 0.0;
  for (const double leak : outcome.leaks_mm2) sum += counted_leak(leak);
  return sum / static_cast<double>(outcome.leaks_mm2.size());
}

}  // namespace coapt
