#include "search/plans/effort.h"

namespace coapt {
namespace {

double movement_mm(const Valve& before, const Valve& repaired, Side side) {
  for (std::size_t h = 0; h < before.heads.size(); ++h)
    if (before.heads[h].side == side)
      return (repaired.heads[h].tip_mm - before.heads[h].tip_mm).norm();
  return 0.0;
}

}  // namespace

Effort effort(const Valve& before, const Valve& repaired, const RepairPlan& plan) {
  const bool ring = repaired.annulus_mm != before.annulus_mm;
  return {movement_mm(before, repaired, Side::Anterolateral),
          movement_mm(before, repaired, Side::Posteromedial),
          ring ? ring_sizes_below(before, repaired) : 0.0, static_cast<int>(plan.steps.size())};
}

}  // namespace coapt
