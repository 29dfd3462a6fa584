#include "search/plans/model_closures.h"

#include <algorithm>
#include <array>
#include <limits>

#include "core/metrics/mean_and_sd.h"
#include "core/presets/synthetic_chordae.h"
#include "core/repair/apply_plan.h"
#include "search/fit/fitted_draw.h"
#include "search/latin_hypercube.h"
#include "search/model_draw.h"
#include "search/parallel.h"

namespace coapt {
namespace {

constexpr int kMostSeed = 0x7fffffff;
constexpr std::uint64_t kSeed = 1,
                        kFitSeed = 2;  // not the search's: another search, the same draws

PlanClosure refused() {
  PlanClosure closure;
  closure.status = ClosureStatus::Diverged;
  return closure;
}

/// The unrepaired valve in each draw: with other values where a fit left them uncertain, with other chordae where its own were
/// never seen, else as it is. Empty where such a valve cannot be made.
std::vector<std::optional<Valve>> drawn_valves(const PlanEvaluations& evaluations, int draws) {
  std::vector<std::optional<Valve>> valves(static_cast<std::size_t>(draws), evaluations.valve());
  const Valve& valve = evaluations.valve();
  if (!valve.fitted && !valve.drawn_chordae) return valves;
  const std::vector<std::vector<double>> shares =
      valve.fitted
          ? latin_hypercube(draws, static_cast<int>(valve.fitted->parameters.size()), kFitSeed)
          : std::vector<std::vector<double>>{};
  const auto drawn = [&](int draw) {
    if (valve.fitted) return with_fitted_draw(valve, shares[static_cast<std::size_t>(draw)]);
    return redrawn_chordae(valve,
                           static_cast<int>((valve.drawn_chordae->seed + 1LL + draw) & kMostSeed));
  };
  for_each_index(draws, evaluations.threads(), [&](int draw) {
    if (evaluations.cancelled()) return;
    const Expected<Valve> other = drawn(draw);
    valves[static_cast<std::size_t>(draw)] = other ? std::optional(*other) : std::nullopt;
  });
  return valves;
}

/// The plan, or none, on a valve with the material of a draw.
std::optional<Valve> planned(const std::optional<Valve>& valve, const PlanRecord* plan,
                             const std::vector<double>& shares) {
  if (!valve) return {};
  const Expected<Valve> repaired = plan == nullptr ? *valve : apply_plan(*valve, plan->plan);
  if (!repaired) return {};
  const Expected<Valve> drawn = with_model(*repaired, shares);
  return drawn ? std::optional(*drawn) : std::nullopt;
}

}  // namespace

ModelClosures close_under_draws(PlanEvaluations& evaluations, const std::vector<PlanRecord*>& plans,
                                int draws) {
  ModelClosures model;
  if (draws == 0) return model;
  model.draws = draws;
  const std::vector<std::vector<double>> shares = model_draws(draws, kSeed);
  const int count = static_cast<int>(plans.size()) + 1;  // the last: no repair
  const std::vector<std::optional<Valve>> valves = drawn_valves(evaluations, draws);
  std::vector<ClosedPlan> starts;
  for (const PlanRecord* plan : plans) starts.push_back(evaluations.closed(*plan));
  starts.push_back(evaluations.closed_before());
  std::vector<double> thickness_mm(draws);
  std::vector<std::optional<PlanClosure>> closures(static_cast<std::size_t>(count) * draws);
  for_each_index(count * draws, evaluations.threads(), [&](int i) {
    if (evaluations.cancelled()) return;
    const PlanRecord* plan = i / draws == count - 1 ? nullptr : plans[i / draws];
    const std::optional<Valve> drawn = planned(valves[i % draws], plan, shares[i % draws]);
    if (drawn && plan == nullptr) thickness_mm[i % draws] = drawn->tissue.thickness_mm;
    closures[i] =
        drawn
            ? plan_closure(evaluations.evaluate(*drawn, starts[i / draws].closure.get()).evaluation)
            : refused();
  });
  for (const auto& closure : closures) model.closures += closure.has_value();
  if (model.closures < std::ssize(closures)) return model;
  for (int i = 0; i < count; ++i) {
    std::vector<PlanClosure>& by_draw = i + 1 == count ? model.before : model.plans[plans[i]];
    for (int draw = 0; draw < draws; ++draw) by_draw.push_back(*closures[i * draws + draw]);
  }
  for (int draw = 0; draw < draws; ++draw) {
    CostContext& there = model.contexts.emplace_back(evaluations.context());
    const PlanClosure& before = model.before[draw];
    there.thickness_mm = thickness_mm[draw];
    there.tension_before_n =
        trusted(before) ? before.tension_max_n : std::numeric_limits<double>::infinity();
  }
  return model;
}

ModelSpread model_spread(const std::vector<PlanClosure>& by_draw) {
  ModelSpread spread;
  spread.draws = static_cast<int>(by_draw.size());
  std::vector<double> leaks;
  for (const PlanClosure& closure : by_draw)
    if (trusted(closure)) leaks.push_back(closure.leak_mm2);
  spread.failures = spread.draws - static_cast<int>(leaks.size());
  if (leaks.empty()) return spread;
  const auto [mean, sd] = mean_and_sd(leaks);
  spread.mean_mm2 = mean;
  spread.sd_mm2 = sd;
  spread.worst_mm2 = *std::max_element(leaks.begin(), leaks.end());
  return spread;
}

DrawnChange change_in_draw(const PlanEvaluations& evaluations, const PlanRecord& plan,
                           const ModelClosures& model, int draw) {
  const PlanClosure& own = plan.closures.at(0);
  const PlanClosure& drawn = model.plans.at(&plan)[draw];
  if (!trusted(own) || !trusted(drawn)) return {false, 0.0, 0.0};
  const auto cost = [&](const PlanClosure& closure, const CostContext& context) {
    return plan_cost(std::array{ScoredClosure{closure, 0.0}}, plan.effort, context);
  };
  return {true, drawn.leak_mm2 - own.leak_mm2,
          cost(drawn, model.contexts[draw]) - cost(own, evaluations.context())};
}

}  // namespace coapt
