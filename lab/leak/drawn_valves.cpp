#include "lab/leak/drawn_valves.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <random>

#include "core/presets/human_presets.h"
#include "core/presets/presets.h"
#include "core/repair/apply_plan.h"
#include "core/valve/number_text.h"
#include "core/valve/remodel.h"
#include "search/random_share.h"

namespace coapt {
namespace {

constexpr int kRepairs = 5;

class ValveDice {
 public:
  ValveDice(std::uint64_t seed, int number) {
    std::seed_seq sequence{static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32),
                           static_cast<std::uint32_t>(number)};
    engine_.seed(sequence);
  }
  double between(double low, double high) { return std::lerp(low, high, random_share(engine_)); }
  int below(int count) { return static_cast<int>(between(0.0, count)); }

 private:
  std::mt19937_64 engine_;
};

struct NamedHuman {
  const char* name;
  HumanValve (*human)();
};
constexpr NamedHuman kHumans[] = {{"human-normal", human_normal},
                                  {"human-functional-mr", human_functional_mr},
                                  {"human-p2-prolapse", human_p2_prolapse},
                                  {"barlow", barlow},
                                  {"fibroelastic-flail", fibroelastic_flail},
                                  {"marfan", marfan},
                                  {"secondary-mr", secondary_mr},
                                  {"hypertrophic", hypertrophic}};

Expected<Valve> with_clefts(ValveDice& dice) {
  const NamedHuman& one = kHumans[dice.below(static_cast<int>(std::size(kHumans)))];
  HumanValve human = one.human();
  human.dimensions.cleft_depth_mm = dice.between(1.0, 5.0);
  human.dimensions.name =
      one.name + (", clefts " + with_decimals(human.dimensions.cleft_depth_mm, 1)) + " mm";
  return make_human_valve(human);
}

Remodelling drawn_change(ValveDice& dice) {
  constexpr double kMostDisplacement_mm = 6.0;
  Remodelling change;
  change.ap_dilation_percent = dice.between(0.0, 26.0);
  change.annular_height_percent = dice.between(60.0, 120.0);
  for (Vec3* tip : {&change.anterolateral_mm, &change.posteromedial_mm}) {
    const double length_mm = dice.between(0.0, kMostDisplacement_mm);
    Vec3 direction;
    for (int k = 0; k < 3; ++k) direction[k] = dice.between(0.01, 1.0);
    *tip = length_mm * direction.normalized();
  }
  return change;
}

Annuloplasty drawn_ring(ValveDice& dice) { return {OwnRing{dice.below(4)}}; }

EdgeToEdge drawn_clip(ValveDice& dice) {
  return {EdgeDevice::Clip, dice.between(1.0 / 3.0, 2.0 / 3.0), dice.between(4.0, 6.0)};
}

/// From head to leaflet, mean over the marginal chordae of a side.
double marginal_length_mm(const Valve& valve, Side side) {
  double sum_mm = 0.0;
  int count = 0;
  for (const Chorda& chorda : valve.chordae) {
    if (chorda.kind != ChordaKind::Marginal ||
        valve.heads[static_cast<std::size_t>(chorda.head)].side != side)
      continue;
    for (int at = static_cast<int>(chorda.segments.size()) - 1; at >= 0;) {
      const ChordaSegment& segment = chorda.segments[static_cast<std::size_t>(at)];
      sum_mm += segment.rest_length_mm;
      at = segment.parent;
    }
    ++count;
  }
  return sum_mm / std::max(1, count);
}

Neochorda drawn_neochorda(const Valve& valve, Side side, Leaflet leaflet, ValveDice& dice) {
  const auto head = std::find_if(valve.heads.begin(), valve.heads.end(),
                                 [&](const PapillaryHead& one) { return one.side == side; });
  const double off = dice.between(0.05, 0.25);
  return {head->id,
          {leaflet, side == Side::Anterolateral ? 0.5 - off : 0.5 + off, 1.0},
          dice.between(0.85, 1.0) * marginal_length_mm(valve, side)};
}

RepairPlan drawn_repair(const Valve& valve, const std::string& repair, ValveDice& dice) {
  RepairPlan plan;
  if (repair.starts_with("ring")) plan.steps.emplace_back(drawn_ring(dice));
  if (repair.ends_with("clip")) plan.steps.emplace_back(drawn_clip(dice));
  if (repair == "neochordae") {
    const Leaflet leaflet = dice.below(3) == 0 ? Leaflet::Anterior : Leaflet::Posterior;
    for (const Side side : {Side::Anterolateral, Side::Posteromedial})
      plan.steps.emplace_back(drawn_neochorda(valve, side, leaflet, dice));
  }
  return plan;
}

}  // namespace

DrawnValve drawn_valve(int number, std::uint64_t seed) {
  const std::vector<std::string>& presets = preset_names();
  if (number < std::ssize(presets)) {
    const std::string& name = presets[static_cast<std::size_t>(number)];
    return {name, "none", *make_preset(name)};
  }
  constexpr std::array<const char*, kRepairs> kNames = {"none", "ring", "clip", "neochordae",
                                                        "ring+clip"};
  const int drawn = number - static_cast<int>(presets.size());
  const std::string repair = kNames[static_cast<std::size_t>(drawn % kRepairs)];
  ValveDice dice(seed, number);
  while (true) {  // some draws make no valve, or one that the repair does not fit
    const Expected<Valve> sound =
        drawn / kRepairs % 2 == 0
            ? make_preset(
                  presets[static_cast<std::size_t>(dice.below(static_cast<int>(presets.size())))])
            : with_clefts(dice);
    if (!sound) continue;
    const Expected<Valve> ill = remodel(*sound, drawn_change(dice));
    if (!ill) continue;
    const Expected<Valve> repaired = apply_plan(*ill, drawn_repair(*ill, repair, dice));
    if (repaired) return {sound->name, repair, *repaired};
  }
}

}  // namespace coapt
