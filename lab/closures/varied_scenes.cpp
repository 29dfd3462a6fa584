#include "lab/closures/varied_scenes.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "core/repair/apply_plan.h"
#include "core/repair/limits.h"
#include "core/repair/rings.h"
#include "core/valve/annulus_frame.h"
#include "core/valve/remodel.h"
#include "search/random_share.h"

namespace coapt {
namespace {

constexpr double kMostDilation_percent = 30.0;
constexpr double kMostDisplacement_mm = 6.0;
constexpr double kNeighbour_mm = 1.0;
constexpr double kRepairShare = 0.4;  // of the scenes
constexpr double kMostShortening_mm = 8.0;

class Dice {
 public:
  Dice(std::uint64_t seed, int index) {
    std::seed_seq sequence{static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32),
                           static_cast<std::uint32_t>(index)};
    engine_.seed(sequence);
  }
  double operator()() { return random_share(engine_); }

 private:
  std::mt19937_64 engine_;
};

Remodelling disease(Dice& dice) {
  Remodelling change;
  change.ap_dilation_percent = kMostDilation_percent * dice();
  change.annular_height_percent = 80.0 + 40.0 * dice();
  for (Vec3* tip : {&change.anterolateral_mm, &change.posteromedial_mm}) {
    const double length = kMostDisplacement_mm * dice();
    Vec3 direction;
    for (int k = 0; k < 3; ++k) direction[k] = dice();
    *tip = length / std::max(1e-3, direction.norm()) * direction;
  }
  return change;
}

RepairPlan repair(const Valve& valve, SceneRings rings, Dice& dice) {
  RepairPlan plan;
  if (dice() < kRepairShare && rings == SceneRings::Catalogue) {
    CatalogueRing ring;
    ring.shape = kRingShapes[static_cast<std::size_t>(dice() * kRingShapes.size())].name;
    const double width = transverse_diameter_mm(valve);
    const double below = kRingSizeStep_mm * std::floor((kMostSizesBelow + 1.0) * dice());
    ring.size_mm = std::clamp(kRingSizeStep_mm * std::floor(width / kRingSizeStep_mm) - below,
                              kRingSizesMm.min, kRingSizesMm.max);
    plan.steps.push_back(Annuloplasty{ring});
  }
  for (const Side side : {Side::Anterolateral, Side::Posteromedial}) {
    if (dice() >= kRepairShare) continue;
    PapillaryApproximation suture;
    suture.side = side;
    suture.anchor = dice() < 0.5 ? Anchor::IpsilateralTrigone : Anchor::SaddlePeak;
    const int anchor = suture.anchor == Anchor::SaddlePeak ? valve.landmarks.saddle_peak
                       : side == Side::Anterolateral       ? valve.landmarks.anterolateral_trigone
                                                           : valve.landmarks.posteromedial_trigone;
    const double distance =
        (annulus_position_mm(valve, anchor) - papillary_tip_mm(valve, side)).norm();
    suture.suture_length_mm = distance - kMostShortening_mm * dice();
    plan.steps.push_back(suture);
  }
  return plan;
}

Vec3 step_of(Dice& dice) {
  const double length = kNeighbour_mm * dice();
  Vec3 direction;
  for (int k = 0; k < 3; ++k) direction[k] = 2.0 * dice() - 1.0;
  return length / std::max(1e-3, direction.norm()) * direction;
}

Valve with_tips_moved(const Valve& scene, const Vec3& anterolateral, const Vec3& posteromedial) {
  Remodelling change;
  change.anterolateral_mm = anterolateral;
  change.posteromedial_mm = posteromedial;
  const Expected<Valve> moved = remodel(scene, change);
  return moved ? *moved : scene;
}

}  // namespace

Valve varied_scene(const Valve& valve, std::uint64_t seed, int index, SceneRings rings) {
  Dice dice(seed, index);
  const Expected<Valve> diseased = remodel(valve, disease(dice));
  Valve scene = diseased ? *diseased : valve;
  for (const RepairStep& step : repair(scene, rings, dice).steps) {
    const Expected<Valve> repaired = apply_plan(scene, {{step}});
    if (repaired) scene = *repaired;
  }
  return scene;
}

Valve neighbour_of(const Valve& scene, std::uint64_t seed, int index) {
  Dice dice(~seed, index);
  const Vec3 anterolateral = step_of(dice), posteromedial = step_of(dice);
  return with_tips_moved(scene, anterolateral, posteromedial);
}

SceneFrame frame_of(const Valve& scene, std::uint64_t seed, int index) {
  Dice dice(~seed, index);
  const Vec3 middle = step_of(dice);
  std::vector<Vec3> places = {middle};
  for (int k = 0; k < 3; ++k)
    for (const double sign : {1.0, -1.0})
      places.emplace_back(middle + sign * kNeighbour_mm * Vec3::Unit(k));
  SceneFrame frame;
  for (const Vec3& place : places) {
    frame.valves.push_back(with_tips_moved(scene, place, place));
    frame.moved_mm.emplace_back(place - middle);
  }
  frame.scene_mm = -middle;
  return frame;
}

}  // namespace coapt
