// What a plan space offers of each decision, by rules.
#include <algorithm>
#include <cmath>

#include "core/repair/annuloplasty.h"
#include "core/repair/apply_plan.h"
#include "core/repair/approximation.h"
#include "core/repair/limits.h"
#include "core/valve/annulus_frame.h"
#include "search/plans/plan_space.h"

namespace coapt {
namespace {

constexpr double kMostNormalTipToTrigone_mm = 23.5 + 3.8;  // mean + sd, 57 cadavers
constexpr double kFunctionalSizesBelow = 2.0;              // where practice starts (2 to 4)

template <class Step>
bool has_step(const RepairPlan& plan) {
  return std::any_of(plan.steps.begin(), plan.steps.end(),
                     [](const RepairStep& step) { return std::holds_alternative<Step>(step); });
}

std::string in_mm(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1f mm", value);
  return text;
}

}  // namespace

bool has_suture(const RepairPlan& plan, Side side) {
  return std::any_of(plan.steps.begin(), plan.steps.end(), [side](const RepairStep& step) {
    const auto* suture = std::get_if<PapillaryApproximation>(&step);
    return suture != nullptr && suture->side == side;
  });
}

std::vector<std::string> PlanSpace::offer_rings() {
  if (has_step<Annuloplasty>(rules_.fixed)) {
    cut_.push_back({"other rings", "the ring is fixed"});
    return {""};
  }
  std::vector<std::string> offered = {""};
  const double width = transverse_diameter_mm(valve_, annulus_frame(valve_));
  const auto try_ring = [&](const Annuloplasty& ring, double size) {
    RepairPlan plan = rules_.fixed;
    plan.steps.emplace_back(ring);
    const Expected<Valve> valve = apply_plan(valve_, plan, catalogue_);
    if (valve) ringed_[{ring.shape, static_cast<int>(std::lround(2.0 * size))}] = {plan, *valve};
    return bool(valve);
  };
  const auto offer = [&](const std::string& shape, const std::vector<double>& sizes) {
    if (is_forbidden(rules_, "annuloplasty", shape)) {
      cut_.push_back({"ring " + shape, "forbidden"});
    } else if (sizes.empty()) {
      cut_.push_back({"ring " + shape, "no size is 0 to 4 sizes below this annulus (" +
                                           in_mm(width) + " wide), or none fits"});
    } else {
      offered.push_back(shape);
    }
  };
  std::vector<double> sizes;
  for (int below = 1; below <= static_cast<int>(kMostSizesBelow); ++below)
    if (try_ring({.shape = "own", .sizes_below = below}, below)) sizes.push_back(below);
  offer("own", sizes);
  for (const RingShape& shape : catalogue_) {
    sizes.clear();
    for (double size = kRingSizesMm.min; size <= kRingSizesMm.max; size += kRingSizeStep_mm) {
      const double below = (width - ring_width_mm(shape, size)) / kRingSizeStep_mm;
      if (below >= 0.0 && below <= kMostSizesBelow &&
          try_ring({.shape = shape.name, .size_mm = size}, size))
        sizes.push_back(size);
    }
    offer(shape.name, sizes);
  }
  return offered;
}

Parameter PlanSpace::ring_sizes(const std::string& shape) const {
  double first = 1e9, last = -1e9;
  for (const auto& [key, ringed] : ringed_) {
    if (key.first != shape) continue;
    first = std::min(first, 0.5 * key.second);
    last = std::max(last, 0.5 * key.second);
  }
  const double below = lesion_ ? 0.0 : kFunctionalSizesBelow;
  if (shape == "own")
    return make_parameter(ParameterOf::RingSize, 0, {first, last}, 1.0, std::max(1.0, below));
  const double width = transverse_diameter_mm(valve_, annulus_frame(valve_));
  const double factor = find_ring(catalogue_, shape)->transverse_factor;
  return make_parameter(ParameterOf::RingSize, 0, {first, last}, kRingSizeStep_mm,
                        (width - kRingSizeStep_mm * below) / factor);
}

std::vector<std::optional<Anchor>> PlanSpace::offer_anchors(Side side) {
  const std::string what = std::string("suture of the ") + to_string(side) + " muscle";
  if (has_suture(rules_.fixed, side)) {
    cut_.push_back({what, "its suture is fixed"});
    return {std::nullopt};
  }
  if (is_forbidden(rules_, "papillary_approximation", to_string(side))) {
    cut_.push_back({what, "forbidden"});
    return {std::nullopt};
  }
  const double distance = anchor_distance_mm(valve_, {.side = side});
  if (distance <= kMostNormalTipToTrigone_mm) {
    cut_.push_back(
        {what, "not displaced: " + in_mm(distance) + " from its trigone, up to 27.3 mm is normal"});
    return {std::nullopt};
  }
  std::vector<std::optional<Anchor>> anchors = {std::nullopt};
  for (const Anchor anchor : {Anchor::IpsilateralTrigone, Anchor::SaddlePeak, Anchor::AnnulusPoint})
    if (is_forbidden(rules_, "papillary_approximation", to_string(anchor))) {
      cut_.push_back({what + " to " + to_string(anchor), "forbidden"});
    } else {
      anchors.push_back(anchor);
    }
  return anchors;
}

std::vector<int> PlanSpace::offer_neochordae() {
  std::string why;
  if (!lesion_) why = "no marginal chorda is ruptured";
  if (lesion_ && is_forbidden(rules_, "neochorda", to_string(lesion_->leaflet))) why = "forbidden";
  if (rules_.most_neochordae == 0) why = "none are allowed";
  if (!why.empty()) {
    cut_.push_back({"neochordae", why});
    return {0};
  }
  std::vector<int> counts;
  for (int count = 0; count <= rules_.most_neochordae; ++count) counts.push_back(count);
  return counts;
}

std::vector<ChordalChoice> PlanSpace::offer_chordal() {
  std::vector<ChordalChoice> offered = {ChordalChoice::None};
  if (rules_.chordal_excision && !is_forbidden(rules_, "chordal_excision", "") &&
      !anterior_struts(valve_, coordinates_).empty())
    offered.push_back(ChordalChoice::CutStruts);
  if (!lesion_) return offered;
  if (rules_.chordal_length_change && !is_forbidden(rules_, "chordal_length_change", "") &&
      !chordae_beside(valve_, coordinates_, *lesion_, 1).empty())
    offered.push_back(ChordalChoice::Shorten);
  if (rules_.chordal_transfer && !is_forbidden(rules_, "chordal_transfer", "") &&
      chorda_opposite(valve_, coordinates_, *lesion_) >= 0)
    offered.push_back(ChordalChoice::Transfer);
  return offered;
}

}  // namespace coapt
