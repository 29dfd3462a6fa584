#include "search/plans/model_closures.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <limits>
#include <numeric>
#include <utility>

#include "core/metrics/mean_and_sd.h"
#include "search/parallel.h"

namespace coapt {
namespace {

PlanClosure refused() {
  PlanClosure closure;
  closure.status = ClosureStatus::Diverged;
  return closure;
}

/// `count` draws, the block's own; not of the search's seed: another search, the same draws.
std::vector<ModelDraw> drawn(const PlanEvaluations& evaluations, int count, int block) {
  const ModelDraws draws(evaluations.valve(), {.count = count, .block = block});
  std::vector<ModelDraw> all(static_cast<std::size_t>(count));
  for_each_index(count, evaluations.threads(), [&](int i) {
    if (!evaluations.cancelled()) all[static_cast<std::size_t>(i)] = draws.at(i);
  });
  return all;
}

/// The unrepaired valve in a draw.
struct Before {
  PlanClosure closure;
  double thickness_mm = 0.0;
  std::optional<InformedDraw> informed = {};  ///< of one that closes
};

/// None if the search was cancelled before.
std::vector<std::optional<Before>> close_before(PlanEvaluations& evaluations,
                                                const std::vector<ModelDraw>& draws) {
  const ClosedPlan start = evaluations.closed_before();
  std::vector<std::optional<Before>> all(draws.size());
  for_each_index(static_cast<int>(draws.size()), evaluations.threads(), [&](int i) {
    if (evaluations.cancelled()) return;
    const auto at = static_cast<std::size_t>(i);
    all[at] = Before{refused()};
    const std::optional<Valve> valve = drawn_valve(draws[at], nullptr);
    if (!valve) return;
    const ClosedPlan closed =
        with_leak_surface(*valve, evaluations.evaluate(*valve, start.closure.get()));
    all[at]->closure = plan_closure(closed.evaluation);
    all[at]->thickness_mm = valve->tissue.thickness_mm;
    const ValveMeasure& measure = closed.evaluation.measure;
    if (trusted(closed.evaluation))
      all[at]->informed = {0.0, 0.0, draws[at].shares, model_figures(measure),
                           shape_figures(measure)};
  });
  return all;
}

/// A plan in a draw, as a search closes it; `measured`: its leak by the surface, if the closure was kept.
struct DrawnClosure {
  PlanClosure closure;
  std::optional<PlanClosure> measured = {};
};

DrawnClosure close_drawn(PlanEvaluations& evaluations, const Valve& valve,
                         const ClosureResult* start) {
  const ClosedPlan closed = evaluations.evaluate(valve, start);
  DrawnClosure drawn{plan_closure(closed.evaluation)};
  if (closed.closure != nullptr)
    drawn.measured = plan_closure(with_leak_surface(valve, closed).evaluation);
  return drawn;
}

/// The draws, closed without a repair; no `before` if the search was cancelled.
ModelClosures draw_and_close_before(PlanEvaluations& evaluations, int asked) {
  ModelClosures model;
  const std::vector<Observation>& observed = evaluations.valve().observed;
  const auto [draws, blocks] = draw_blocks(observed, asked);
  model.draws = draws;
  std::vector<ModelDraw> pool;
  std::vector<Before> before;
  Conditioning found;
  for (int block = 0; block < blocks; ++block) {
    std::vector<ModelDraw> more = drawn(evaluations, draws, block);
    const std::vector<std::optional<Before>> closed = close_before(evaluations, more);
    for (const std::optional<Before>& one : closed) {
      if (!one) return model;  // cancelled
      before.push_back(*one);
      ++model.closures;
    }
    std::move(more.begin(), more.end(), std::back_inserter(pool));
    std::vector<std::optional<ModelFigures>> figures;
    for (const Before& one : before)
      figures.push_back(one.informed ? std::optional(one.informed->figures) : std::nullopt);
    found = condition(observed, figures);
    if (found.effective >= kLeastEffective && !found.contradicts) break;
  }
  model.pool = static_cast<int>(pool.size());
  model.contradicts = found.contradicts;
  model.effective = observed.empty() ? draws : found.effective;
  // Draws that are not to be trusted weigh nothing; where none is, or nothing is weighed, the first ones stand.
  const bool weighed = !observed.empty() && !found.contradicts && found.effective > 0.0;
  std::vector<int> picked(static_cast<std::size_t>(draws));
  std::iota(picked.begin(), picked.end(), 0);
  if (weighed) picked = resampled(found.weights, draws);
  int last = -1;
  for (const int draw : picked) {  // in order
    const auto at = static_cast<std::size_t>(draw);
    if (draw != last) {
      model.distinct.push_back(std::move(pool[at]));
      model.informed.push_back(before[at].informed);
    }
    last = draw;
    model.picked.push_back(static_cast<int>(model.distinct.size()) - 1);
    const Before& own = before[at];
    model.before.push_back(own.closure);
    CostContext& there = model.contexts.emplace_back(evaluations.context());
    there.thickness_mm = own.thickness_mm;
    there.tension_before_n =
        trusted(own.closure) ? own.closure.tension_max_n : std::numeric_limits<double>::infinity();
  }
  return model;
}

}  // namespace

ModelClosures close_under_draws(PlanEvaluations& evaluations, const std::vector<PlanRecord*>& plans,
                                int asked, ModelClosures known) {
  if (asked == 0) return {};
  ModelClosures model =
      known.before.empty() ? draw_and_close_before(evaluations, asked) : std::move(known);
  if (model.before.empty()) return model;
  std::vector<const PlanRecord*> missing;
  std::vector<ClosedPlan> starts;
  for (const PlanRecord* plan : plans) {
    if (model.plans.contains(plan)) continue;
    missing.push_back(plan);
    starts.push_back(evaluations.closed(*plan));
  }
  const auto count = static_cast<int>(missing.size());
  const auto each = static_cast<int>(model.distinct.size());
  std::vector<std::optional<DrawnClosure>> closures(missing.size() * model.distinct.size());
  for_each_index(count * each, evaluations.threads(), [&](int i) {
    if (evaluations.cancelled()) return;
    const ModelDraw& draw = model.distinct[static_cast<std::size_t>(i % each)];
    const std::optional<Valve> valve = drawn_valve(draw, &missing[i / each]->plan);
    closures[i] = valve ? close_drawn(evaluations, *valve, starts[i / each].closure.get())
                        : DrawnClosure{refused(), refused()};
  });
  for (const auto& closure : closures) model.closures += closure.has_value();
  if (std::any_of(closures.begin(), closures.end(), [](const auto& one) { return !one; })) {
    model.before.clear();  // cancelled
    model.contexts.clear();
    model.plans.clear();
    model.measured.clear();
    return model;
  }
  const bool kept = std::all_of(closures.begin(), closures.end(),
                                [](const auto& one) { return one->measured.has_value(); });
  for (const int draw : model.picked)
    for (int i = 0; i < count; ++i) {
      const DrawnClosure& drawn = *closures[static_cast<std::size_t>(i * each + draw)];
      model.plans[missing[i]].push_back(drawn.closure);
      if (kept) model.measured[missing[i]].push_back(*drawn.measured);
    }
  return model;
}

std::vector<InformationRow> information_rows(const ModelClosures& model, const PlanRecord& plan) {
  const auto measured = model.measured.find(&plan);
  if (measured == model.measured.end() || model.contradicts || model.pool < kConditionedDraws)
    return {};
  std::vector<InformedDraw> draws;
  for (std::size_t i = 0; i < model.picked.size(); ++i) {
    const PlanClosure& closure = measured->second[i];
    const auto at = static_cast<std::size_t>(model.picked[i]);
    if (!model.informed[at] || !trusted(closure)) continue;
    if (i > 0 && model.picked[i] == model.picked[i - 1]) {
      draws.back().weight += 1.0;  // one that was picked several times weighs more
      continue;
    }
    draws.push_back(*model.informed[at]);
    draws.back().leak_mm2 = closure.leak_mm2;
    draws.back().weight = 1.0;
  }
  return information_rows(draws, model.effective);
}

int most_draw_closures(const Valve& valve, int plans, int asked) {
  const auto [draws, blocks] = draw_blocks(valve.observed, asked);
  return draws * (blocks + plans);
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
