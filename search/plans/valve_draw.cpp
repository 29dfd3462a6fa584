#include "search/plans/valve_draw.h"

#include "core/presets/synthetic_chordae.h"
#include "core/repair/apply_plan.h"
#include "search/fit/fitted_draw.h"
#include "search/latin_hypercube.h"
#include "search/model_draw.h"

namespace coapt {
namespace {

constexpr int kMostSeed = 0x7fffffff;
constexpr std::uint64_t kFitApart = 1'000'003;  // fitted values have draws of their own

std::uint64_t seed_of(const ModelDrawing& drawing) {
  return drawing.seed + static_cast<std::uint64_t>(drawing.block);
}

}  // namespace

ModelDraws::ModelDraws(const Valve& valve, const ModelDrawing& drawing)
    : valve_(valve),
      first_(drawing.block * drawing.count),
      shares_(model_draws(drawing.count, seed_of(drawing))) {
  if (valve.fitted)
    fitted_ = latin_hypercube(drawing.count, static_cast<int>(valve.fitted->parameters.size()),
                              seed_of(drawing) + kFitApart);
}

ModelDraw ModelDraws::at(int i, const ClosureBudget& budget) const {
  const auto at = static_cast<std::size_t>(i);
  ModelDraw draw{shares_[at], {}};
  if (!valve_.fitted && !valve_.drawn_chordae) {
    draw.valve = valve_;
    return draw;
  }
  const long long seed = valve_.drawn_chordae ? valve_.drawn_chordae->seed + 1LL + first_ + i : 0;
  const Expected<Valve> other =
      valve_.fitted ? with_fitted_draw(valve_, fitted_[at])
                    : redrawn_chordae(valve_, static_cast<int>(seed & kMostSeed), budget);
  if (other) draw.valve = *other;
  return draw;
}

std::optional<Valve> drawn_valve(const ModelDraw& draw, const RepairPlan* plan) {
  if (!draw.valve) return {};
  const Expected<Valve> repaired = plan == nullptr ? *draw.valve : apply_plan(*draw.valve, *plan);
  if (!repaired) return {};
  const Expected<Valve> drawn = with_model(*repaired, draw.shares);
  return drawn ? std::optional(*drawn) : std::nullopt;
}

}  // namespace coapt
