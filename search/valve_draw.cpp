#include "search/valve_draw.h"

#include "core/presets/synthetic_chordae.h"
#include "core/repair/apply_plan.h"
#include "search/fit/fitted_draw.h"
#include "search/latin_hypercube.h"
#include "search/model_draw.h"
#include "search/parallel.h"

namespace coapt {
namespace {

constexpr int kMostSeed = 0x7fffffff;

}  // namespace

std::vector<ModelDraw> valve_draws(const Valve& valve, const ModelDrawing& drawing) {
  const int count = drawing.count;
  const std::vector<std::vector<double>> shares = model_draws(count, drawing.seed);
  const std::vector<std::vector<double>> fitted =
      valve.fitted ? latin_hypercube(count, static_cast<int>(valve.fitted->parameters.size()),
                                     drawing.fit_seed)
                   : std::vector<std::vector<double>>{};
  std::vector<ModelDraw> draws(static_cast<std::size_t>(count));
  for_each_index(count, drawing.threads, [&](int i) {
    const auto at = static_cast<std::size_t>(i);
    draws[at].shares = shares[at];
    if (!valve.fitted && !valve.drawn_chordae) {
      draws[at].valve = valve;
      return;
    }
    if (drawing.cancelled && drawing.cancelled()) return;
    const long long seed =
        valve.drawn_chordae ? valve.drawn_chordae->seed + 1LL + drawing.first + i : 0;
    const Expected<Valve> other = valve.fitted
                                      ? with_fitted_draw(valve, fitted[at])
                                      : redrawn_chordae(valve, static_cast<int>(seed & kMostSeed));
    if (other) draws[at].valve = *other;
  });
  return draws;
}

std::optional<Valve> drawn_valve(const ModelDraw& draw, const RepairPlan* plan) {
  if (!draw.valve) return {};
  const Expected<Valve> repaired = plan == nullptr ? *draw.valve : apply_plan(*draw.valve, *plan);
  if (!repaired) return {};
  const Expected<Valve> drawn = with_model(*repaired, draw.shares);
  return drawn ? std::optional(*drawn) : std::nullopt;
}

}  // namespace coapt
