#include "search/plans/effort.h"

#include <cmath>

#include "core/repair/limits.h"
#include "core/valve/annulus_frame.h"

namespace coapt {
namespace {

/// AP over transverse: 29 / 39 (PMC7368231), classic rings.
constexpr double kHealthyProportion = 0.75;

double movement_mm(const Valve& before, const Valve& repaired, Side side) {
  for (std::size_t h = 0; h < before.heads.size(); ++h)
    if (before.heads[h].side == side)
      return (repaired.heads[h].tip_mm - before.heads[h].tip_mm).norm();
  return 0.0;
}

}  // namespace

double ring_sizes_below(const Valve& before, const Valve& repaired) {
  const double width = transverse_diameter_mm(before);
  const double share = ap_diameter_mm(repaired) * transverse_diameter_mm(repaired) /
                       (kHealthyProportion * width * width);
  const double narrower_mm = (1.0 - std::sqrt(share)) * width;  // NaN if a diameter is
  return narrower_mm <= 0.0 ? 0.0 : narrower_mm / kRingSizeStep_mm;
}

Effort effort(const Valve& before, const Valve& repaired, const RepairPlan& plan) {
  const bool ring = repaired.annulus_mm != before.annulus_mm;
  return {movement_mm(before, repaired, Side::Anterolateral),
          movement_mm(before, repaired, Side::Posteromedial),
          ring ? ring_sizes_below(before, repaired) : 0.0, static_cast<int>(plan.steps.size())};
}

}  // namespace coapt
