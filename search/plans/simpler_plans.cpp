#include "search/plans/simpler_plans.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <string>
#include <utility>

#include "core/repair/apply_plan.h"
#include "core/repair/approximation.h"
#include "core/repair/limits.h"
#include "core/repair/ring_sizing.h"
#include "core/repair/rings.h"
#include "search/plans/plan_key.h"

namespace coapt {
namespace {

constexpr int kSaferSizes = 2;
constexpr int kSmallerSizes = 2;

bool is_fixed(const SearchRules& rules, const RepairStep& step) {
  return std::any_of(
      rules.fixed.steps.begin(), rules.fixed.steps.end(),
      [&](const RepairStep& fixed) { return plan_key({{fixed}}) == plan_key({{step}}); });
}

/// That rules leave open; null: none.
CatalogueRing* open_ring(RepairPlan& plan, const SearchRules& rules) {
  for (RepairStep& step : plan.steps)
    if (auto* const ring = std::get_if<Annuloplasty>(&step); ring && !is_fixed(rules, step))
      if (auto* const made = std::get_if<CatalogueRing>(&ring->ring)) return made;
  return nullptr;
}

/// Whether there is a next size.
bool enlarge(const Valve& valve, CatalogueRing& ring) {
  const double next_mm = ring.size_mm + kRingSizeStep_mm;
  if (next_mm > kRingSizesMm.max ||
      is_too_wide(valve, ring_width_mm(*find_ring(ring.shape), next_mm)))
    return false;
  ring.size_mm = next_mm;
  return true;
}

/// Its ring made smaller, size by size, as far as practice goes: what a ring alone may need to close what a suture closed.
std::vector<RepairPlan> with_smaller_rings(const Valve& valve, RepairPlan plan,
                                           const SearchRules& rules) {
  std::vector<RepairPlan> versions;
  CatalogueRing* const ring = open_ring(plan, rules);
  while (ring && std::ssize(versions) < kSmallerSizes &&
         ring->size_mm - kRingSizeStep_mm >= kRingSizesMm.min) {
    ring->size_mm -= kRingSizeStep_mm;
    const Expected<Valve> ringed = apply_plan(valve, plan);
    if (!ringed || ring_sizes_below(valve, *ringed) > kMostSizesBelow) break;
    versions.push_back(plan);
  }
  return versions;
}

/// The smallest ring of its shape that is not a whole size below the true one.
RepairPlan with_true_size(const Valve& valve, RepairPlan plan, const SearchRules& rules) {
  CatalogueRing* const ring = open_ring(plan, rules);
  const auto sizes_below = [&] {
    const Expected<Valve> ringed = apply_plan(valve, {{Annuloplasty{*ring}}});
    return ringed ? std::lround(ring_sizes_below(valve, *ringed)) : 0L;
  };
  while (ring && sizes_below() > 0 && enlarge(valve, *ring)) {
  }
  return plan;
}

RepairPlan with_trigones(const Valve& valve, RepairPlan plan, const SearchRules& rules) {
  if (is_forbidden(rules, "papillary_approximation", to_string(Anchor::IpsilateralTrigone)))
    return plan;
  for (const Side side : {Side::Anterolateral, Side::Posteromedial})
    if (const auto* const suture = suture_of(plan, side); suture && !is_fixed(rules, *suture))
      plan = with_anchor(valve, std::move(plan), side, Anchor::IpsilateralTrigone,
                         rules.suture_lattice_mm);
  return plan;
}

/// With the catalogue's next ring shape, whose anteroposterior diameter is shorter, if rules leave it open.
std::optional<RepairPlan> with_shorter_ring(RepairPlan plan, const SearchRules& rules) {
  CatalogueRing* const ring = open_ring(plan, rules);
  if (ring == nullptr) return std::nullopt;
  const auto shape = std::find_if(kRingShapes.begin(), kRingShapes.end(),
                                  [&](const RingShape& one) { return one.name == ring->shape; });
  if (shape == kRingShapes.end() || std::next(shape) == kRingShapes.end() ||
      is_forbidden(rules, "annuloplasty", std::string(std::next(shape)->name)))
    return std::nullopt;
  ring->shape = std::string(std::next(shape)->name);
  return plan;
}

/// Without each of its sutures, if there are two then with a shorter ring and the trigone, too; and without both, then with smaller
/// rings, too.
std::vector<RepairPlan> with_fewer_sutures(const Valve& valve, const RepairPlan& plan,
                                           const SearchRules& rules) {
  std::vector<RepairPlan> versions;
  RepairPlan without_all = plan;
  for (const Side side : {Side::Anterolateral, Side::Posteromedial}) {
    const auto* const suture = suture_of(plan, side);
    if (suture == nullptr || is_fixed(rules, *suture)) continue;
    const auto is_it = [side](const RepairStep& step) {
      const auto* const of = std::get_if<PapillaryApproximation>(&step);
      return of != nullptr && of->side == side;
    };
    RepairPlan without = plan;
    std::erase_if(without.steps, is_it);
    std::erase_if(without_all.steps, is_it);
    if (without.steps.empty()) continue;
    versions.push_back(without);
    if (suture_of(without, Side::Anterolateral) || suture_of(without, Side::Posteromedial))
      if (auto shorter = with_shorter_ring(std::move(without), rules))
        versions.push_back(with_trigones(valve, std::move(*shorter), rules));
  }
  if (without_all.steps.empty() || without_all.steps.size() == plan.steps.size()) return versions;
  std::vector<RepairPlan> smaller = with_smaller_rings(valve, without_all, rules);
  versions.push_back(std::move(without_all));
  std::move(smaller.begin(), smaller.end(), std::back_inserter(versions));
  return versions;
}

/// Others than the plan, each once, and possible.
std::vector<RepairPlan> distinct(const Valve& valve, const RepairPlan& plan,
                                 const std::vector<RepairPlan>& versions) {
  std::vector<RepairPlan> found;
  std::vector<std::string> seen = {plan_key(plan)};
  for (const RepairPlan& version : versions) {
    const std::string key = plan_key(version);
    if (std::find(seen.begin(), seen.end(), key) != seen.end() || !apply_plan(valve, version))
      continue;
    seen.push_back(key);
    found.push_back(version);
  }
  return found;
}

}  // namespace

RepairPlan with_anchor(const Valve& valve, RepairPlan plan, Side side, Anchor anchor,
                       double lattice_mm) {
  RepairPlan before_sutures = plan;
  std::erase_if(before_sutures.steps,
                [](const RepairStep& step) { return !std::holds_alternative<Annuloplasty>(step); });
  const Expected<Valve> ringed = apply_plan(valve, before_sutures);
  if (!ringed) return plan;
  for (RepairStep& step : plan.steps) {
    auto* const suture = std::get_if<PapillaryApproximation>(&step);
    if (suture == nullptr || suture->side != side) continue;
    const double movement = std::min(
        kUsualMovement_mm, anchor_distance_mm(*ringed, *suture) - suture->suture_length_mm);
    suture->anchor = anchor;
    suture->suture_length_mm =
        lattice_mm * std::ceil((anchor_distance_mm(*ringed, *suture) - movement) / lattice_mm);
  }
  return plan;
}

std::vector<RepairPlan> simpler_plans(const Valve& valve, const RepairPlan& plan,
                                      const SearchRules& rules) {
  const RepairPlan truly = with_true_size(valve, plan, rules);
  std::vector<RepairPlan> versions = with_fewer_sutures(valve, plan, rules);
  versions.push_back(with_trigones(valve, plan, rules));
  versions.push_back(truly);
  versions.push_back(with_trigones(valve, truly, rules));
  return distinct(valve, plan, versions);
}

std::vector<RepairPlan> safer_plans(const Valve& valve, const RepairPlan& plan,
                                    const SearchRules& rules) {
  RepairPlan larger = plan;
  std::vector<RepairPlan> versions;
  CatalogueRing* const ring = open_ring(larger, rules);
  while (ring && std::ssize(versions) < kSaferSizes && enlarge(valve, *ring))
    versions.push_back(larger);
  return distinct(valve, plan, versions);
}

}  // namespace coapt
