#include "search/plans/simpler_plans.h"

#include <algorithm>
#include <cmath>

#include "core/repair/apply_plan.h"
#include "core/repair/approximation.h"
#include "core/repair/limits.h"
#include "core/repair/ring_sizing.h"
#include "core/repair/rings.h"
#include "core/valve/annulus_frame.h"
#include "search/plans/plan_key.h"

namespace coapt {
namespace {

bool is_fixed(const SearchRules& rules, const RepairStep& step) {
  return std::any_of(
      rules.fixed.steps.begin(), rules.fixed.steps.end(),
      [&](const RepairStep& fixed) { return plan_key({{fixed}}) == plan_key({{step}}); });
}

/// The smallest ring of its shape that is not a whole size below the true one, no wider than the annulus.
RepairPlan with_true_size(const Valve& valve, RepairPlan plan, const SearchRules& rules) {
  for (RepairStep& step : plan.steps) {
    auto* const ring = std::get_if<Annuloplasty>(&step);
    auto* const made = ring ? std::get_if<CatalogueRing>(&ring->ring) : nullptr;
    if (made == nullptr || is_fixed(rules, step)) continue;
    const auto sizes_below = [&] {
      const Expected<Valve> ringed = apply_plan(valve, {{step}});
      return ringed ? std::lround(ring_sizes_below(valve, *ringed)) : 0L;
    };
    const double next_mm = kRingSizeStep_mm;
    while (sizes_below() > 0 && made->size_mm + next_mm <= kRingSizesMm.max &&
           ring_width_mm(*find_ring(made->shape), made->size_mm + next_mm) <=
               transverse_diameter_mm(valve))
      made->size_mm += next_mm;
  }
  return plan;
}

RepairPlan with_trigones(const Valve& valve, RepairPlan plan, const SearchRules& rules) {
  if (is_forbidden(rules, "papillary_approximation", to_string(Anchor::IpsilateralTrigone)))
    return plan;
  RepairPlan before_sutures = plan;
  std::erase_if(before_sutures.steps,
                [](const RepairStep& step) { return !std::holds_alternative<Annuloplasty>(step); });
  const Expected<Valve> ringed = apply_plan(valve, before_sutures);
  if (!ringed) return plan;
  for (RepairStep& step : plan.steps) {
    auto* const suture = std::get_if<PapillaryApproximation>(&step);
    if (suture == nullptr || is_fixed(rules, step)) continue;
    const double movement = std::min(
        kUsualMovement_mm, anchor_distance_mm(*ringed, *suture) - suture->suture_length_mm);
    suture->anchor = Anchor::IpsilateralTrigone;
    const double lattice = rules.suture_lattice_mm;
    suture->suture_length_mm =
        lattice * std::ceil((anchor_distance_mm(*ringed, *suture) - movement) / lattice);
  }
  return plan;
}

}  // namespace

std::vector<RepairPlan> simpler_plans(const Valve& valve, const RepairPlan& plan,
                                      const SearchRules& rules) {
  std::vector<RepairPlan> found;
  std::vector<std::string> seen = {plan_key(plan)};
  const RepairPlan truly = with_true_size(valve, plan, rules);
  for (const RepairPlan& simpler :
       {with_trigones(valve, plan, rules), truly, with_trigones(valve, truly, rules)}) {
    const std::string key = plan_key(simpler);
    if (std::find(seen.begin(), seen.end(), key) != seen.end() || !apply_plan(valve, simpler))
      continue;
    seen.push_back(key);
    found.push_back(simpler);
  }
  return found;
}

}  // namespace coapt
