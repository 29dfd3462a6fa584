#include "search/strategies.h"

#include <algorithm>
#include <cmath>

#include "core/repair/annuloplasty.h"
#include "core/repair/apply_plan.h"
#include "core/repair/approximation.h"
#include "core/repair/limits.h"
#include "core/valve/annulus_frame.h"
#include "search/neochordae.h"

namespace coapt {
namespace {

constexpr double kNormalTipToTrigone_mm = 23.5 + 3.8;  // mean + sd, 57 cadavers
constexpr double kLeastMovement_mm = 2.0;              // less is not worth a suture
constexpr double kFirstMovement_mm = 5.0;
constexpr double kSutureLattice_mm = 0.5;
constexpr double kNeochordaLattice_mm = 1.0;
constexpr double kNeochordaScope_mm = 8.0;  // either side of the usual length

bool has_ruptured_marginal(const Valve& valve) {
  return std::any_of(valve.chordae.begin(), valve.chordae.end(), [](const Chorda& chorda) {
    return chorda.ruptured && chorda.kind == ChordaKind::Marginal;
  });
}

bool is_displaced(const Valve& valve, Side side) {
  return anchor_distance_mm(valve, {.side = side}) > kNormalTipToTrigone_mm;
}

double transverse_mm(const Valve& valve) {
  return transverse_diameter_mm(valve, annulus_frame(valve));
}

/// Whether a ring of this size is between 0 and 4 sizes below the annulus (own: 1 to 4).
bool is_sensible(const Annuloplasty& ring, const std::vector<RingShape>& catalogue,
                 double transverse) {
  if (ring.shape == "own") return ring.sizes_below >= 1 && ring.sizes_below <= kMostSizesBelow;
  if (ring.size_mm < kRingSizesMm.min || ring.size_mm > kRingSizesMm.max) return false;
  const double below =
      (transverse - ring_width_mm(*find_ring(catalogue, ring.shape), ring.size_mm)) /
      kRingSizeStep_mm;
  return below >= 0.0 && below <= kMostSizesBelow;
}

/// The sensible ring of this shape nearest to `below` sizes under the annulus.
std::optional<Annuloplasty> ring_near(const RingShape& shape,
                                      const std::vector<RingShape>& catalogue, double transverse,
                                      double below) {
  std::optional<Annuloplasty> best;
  double nearest = 1e9;
  for (double size = kRingSizesMm.min; size <= kRingSizesMm.max; size += kRingSizeStep_mm) {
    const Annuloplasty ring{.shape = shape.name, .size_mm = size};
    const double off = std::abs(transverse - kRingSizeStep_mm * below - ring_width_mm(shape, size));
    if (!is_sensible(ring, catalogue, transverse) || off >= nearest) continue;
    nearest = off;
    best = ring;
  }
  return best;
}

int step_count(const Choice& choice) {
  return (choice.ring ? 1 : 0) + (choice.anterolateral ? 1 : 0) + (choice.posteromedial ? 1 : 0) +
         choice.neochordae;
}

std::vector<std::optional<Anchor>> anchors(const Valve& valve, Side side) {
  if (!is_displaced(valve, side)) return {std::nullopt};
  return {std::nullopt, Anchor::IpsilateralTrigone, Anchor::SaddlePeak};
}

std::vector<std::optional<Annuloplasty>> rings(const Valve& valve,
                                               const std::vector<RingShape>& catalogue) {
  const bool degenerative = has_ruptured_marginal(valve);
  const double transverse = transverse_mm(valve);
  std::vector<std::optional<Annuloplasty>> offered = {
      std::nullopt, Annuloplasty{.shape = "own", .sizes_below = degenerative ? 1 : 2}};
  for (const RingShape& shape : catalogue)
    if (const auto ring = ring_near(shape, catalogue, transverse, degenerative ? 0.0 : 2.0))
      offered.push_back(ring);
  return offered;
}

bool is_possible(const Valve& ringed, PapillaryApproximation suture, double length_mm) {
  suture.suture_length_mm = length_mm;
  return bool(apply_plan(ringed, {{suture}}, {}));
}

/// Adds the suture with its parameter. False if the muscle cannot be pulled.
bool add_suture(const Valve& ringed, Side side, Anchor anchor, Strategy& strategy) {
  PapillaryApproximation suture{.side = side, .anchor = anchor};
  const double distance = anchor_distance_mm(ringed, suture);
  const Range accepted = suture_range_mm(distance);
  const double least = std::max(accepted.min, distance - kUsualMovement_mm);
  const double most = std::min(accepted.max, distance - kLeastMovement_mm);
  Parameter parameter;
  parameter.steps = {strategy.plan.steps.size()};
  parameter.lattice_mm = kSutureLattice_mm;
  parameter.lower_mm = kSutureLattice_mm * std::ceil(least / kSutureLattice_mm);
  parameter.upper_mm = kSutureLattice_mm * std::floor(most / kSutureLattice_mm);
  // Tips move along a line, so that all lengths above one that is possible are.
  while (parameter.lower_mm <= parameter.upper_mm &&
         !is_possible(ringed, suture, parameter.lower_mm))
    parameter.lower_mm += parameter.lattice_mm;
  if (parameter.upper_mm < parameter.lower_mm) return false;
  parameter.start_mm =
      std::clamp(kSutureLattice_mm * std::round((distance - kFirstMovement_mm) / kSutureLattice_mm),
                 parameter.lower_mm, parameter.upper_mm);
  suture.suture_length_mm = parameter.start_mm;
  strategy.plan.steps.emplace_back(suture);
  strategy.parameters.push_back(parameter);
  return true;
}

void add_neochordae(const Valve& valve, int count, Strategy& strategy) {
  for (const NeochordaGroup& group : neochordae_for_ruptures(valve, count)) {
    Parameter parameter;
    parameter.lattice_mm = kNeochordaLattice_mm;
    const double usual =
        std::clamp(std::round(group.length_mm), kUsualNeochordaMm.min, kUsualNeochordaMm.max);
    parameter.lower_mm = std::max(kUsualNeochordaMm.min, usual - kNeochordaScope_mm);
    parameter.upper_mm = std::min(kUsualNeochordaMm.max, usual + kNeochordaScope_mm);
    parameter.start_mm = usual;
    for (Neochorda step : group.steps) {
      step.length_mm = usual;
      parameter.steps.push_back(strategy.plan.steps.size());
      strategy.plan.steps.emplace_back(step);
    }
    strategy.parameters.push_back(parameter);
  }
}

}  // namespace

std::vector<Choice> sensible_choices(const Valve& valve, const std::vector<RingShape>& catalogue) {
  const std::vector<int> neochordae =
      has_ruptured_marginal(valve) ? std::vector<int>{0, 2, 4} : std::vector<int>{0};
  std::vector<Choice> choices;
  for (const auto& ring : rings(valve, catalogue))
    for (const auto& anterolateral : anchors(valve, Side::Anterolateral))
      for (const auto& posteromedial : anchors(valve, Side::Posteromedial))
        for (const int count : neochordae) {
          const Choice choice{ring, anterolateral, posteromedial, count};
          if (step_count(choice) > 0) choices.push_back(choice);
        }
  std::stable_sort(choices.begin(), choices.end(),
                   [](const Choice& a, const Choice& b) { return step_count(a) < step_count(b); });
  return choices;
}

std::vector<Choice> ring_neighbours(const Valve& valve, const std::vector<RingShape>& catalogue,
                                    const Choice& choice) {
  std::vector<Choice> neighbours;
  if (!choice.ring) return neighbours;
  const double transverse = transverse_mm(valve);
  for (const int direction : {-1, 1}) {
    Choice neighbour = choice;
    if (choice.ring->shape == "own")
      neighbour.ring->sizes_below -= direction;
    else
      neighbour.ring->size_mm += direction * kRingSizeStep_mm;
    if (is_sensible(*neighbour.ring, catalogue, transverse)) neighbours.push_back(neighbour);
  }
  return neighbours;
}

std::optional<Strategy> make_strategy(const Valve& valve, const std::vector<RingShape>& catalogue,
                                      const Choice& choice) {
  Strategy strategy;
  strategy.choice = choice;
  if (choice.ring) strategy.plan.steps.emplace_back(*choice.ring);
  const Expected<Valve> ringed = apply_plan(valve, strategy.plan, catalogue);
  if (!ringed) return std::nullopt;
  if (choice.anterolateral &&
      !add_suture(*ringed, Side::Anterolateral, *choice.anterolateral, strategy))
    return std::nullopt;
  if (choice.posteromedial &&
      !add_suture(*ringed, Side::Posteromedial, *choice.posteromedial, strategy))
    return std::nullopt;
  if (choice.neochordae > 0) add_neochordae(valve, choice.neochordae, strategy);
  if (!apply_plan(valve, strategy.plan, catalogue)) return std::nullopt;  // too many chordae
  return strategy;
}

RepairPlan plan_at(const Strategy& strategy, const std::vector<int>& at) {
  RepairPlan plan = strategy.plan;
  for (std::size_t k = 0; k < strategy.parameters.size(); ++k) {
    const Parameter& parameter = strategy.parameters[k];
    const double length = parameter.lower_mm + at[k] * parameter.lattice_mm;
    for (const std::size_t step : parameter.steps) {
      if (auto* suture = std::get_if<PapillaryApproximation>(&plan.steps[step]))
        suture->suture_length_mm = length;
      if (auto* neochorda = std::get_if<Neochorda>(&plan.steps[step]))
        neochorda->length_mm = length;
    }
  }
  return plan;
}

int lattice_size(const Parameter& parameter) {
  return 1 + static_cast<int>(
                 std::lround((parameter.upper_mm - parameter.lower_mm) / parameter.lattice_mm));
}

int lattice_index(const Parameter& parameter, double length_mm) {
  const auto index = std::lround((length_mm - parameter.lower_mm) / parameter.lattice_mm);
  return std::clamp(static_cast<int>(index), 0, lattice_size(parameter) - 1);
}

}  // namespace coapt
