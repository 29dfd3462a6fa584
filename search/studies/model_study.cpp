#include "search/studies/model_study.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>

#include "core/metrics/mean_and_sd.h"
#include "core/metrics/quantile.h"
#include "core/repair/apply_plan.h"
#include "search/parallel.h"
#include "search/threads.h"

namespace coapt {
namespace {

ModelUncertainty uncertainty(double as_it_is_mm2, const std::vector<ModelStudyDraw>& draws) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  ModelUncertainty found{as_it_is_mm2, nan, nan, nan, nan, {}};
  std::vector<std::vector<double>> shares;
  std::vector<double> areas, weights;
  for (const ModelStudyDraw& draw : draws) {
    if (!draw.trusted) continue;
    shares.push_back(draw.shares);
    areas.push_back(draw.leak_mm2);
    weights.push_back(draw.weight);
  }
  if (areas.empty()) return found;
  found.decided_by = sobol_indices(shares, areas);
  const bool alike =
      std::adjacent_find(weights.begin(), weights.end(), std::not_equal_to<>()) == weights.end();
  if (alike) {
    weights.clear();
    const auto [mean, sd] = mean_and_sd(areas);
    found.mean_mm2 = mean;
    found.sd_mm2 = sd;
  } else {
    found.mean_mm2 = std::inner_product(areas.begin(), areas.end(), weights.begin(), 0.0);
    double squares = 0.0;
    for (std::size_t i = 0; i < areas.size(); ++i)
      squares += weights[i] * std::pow(areas[i] - found.mean_mm2, 2);
    found.sd_mm2 = std::sqrt(squares);
  }
  found.p5_mm2 = predicted_quantile(areas, weights, 0.05);
  found.p95_mm2 = predicted_quantile(areas, weights, 0.95);
  return found;
}

void take_figures(const ValveMeasure& measure, ModelStudyDraw& draw) {
  draw.figures = model_figures(measure);
  draw.closed_shape = shape_figures(measure);
}

/// A draw as it is asked for, and of the unrepaired valve where that is another.
ModelStudyDraw closed_draw(const ModelDraw& drawn, const Evaluator& evaluate,
                           const ModelStudyOptions& options) {
  ModelStudyDraw draw{drawn.shares, false, 0.0};
  const std::optional<Valve> valve = drawn_valve(drawn, options.plan);
  if (!valve) return draw;
  const Evaluation evaluation = evaluate(*valve, nullptr).evaluation;
  draw.trusted = trusted(evaluation);
  draw.leak_mm2 = evaluation.measure.leak.area_mm2;
  draw.closed = closed_figures_of(evaluation.measure);
  if (options.plan == nullptr) {
    if (draw.trusted) take_figures(evaluation.measure, draw);
    return draw;
  }
  const std::optional<Valve> before = drawn_valve(drawn, nullptr);
  if (!before) return draw;
  const Evaluation seen = evaluate(*before, nullptr).evaluation;
  if (trusted(seen)) take_figures(seen.measure, draw);
  return draw;
}

/// Draws of the next block; those closed before it was cancelled, in order.
void add_block(const Valve& valve, int block, int count, const Evaluator& evaluate,
               const ModelStudyOptions& options, std::vector<ModelStudyDraw>& all) {
  const auto is_cancelled = [&] { return options.cancelled && options.cancelled(); };
  const ModelDraws drawn(valve, {.count = count, .block = block, .seed = options.seed});
  ClosureBudget budget;
  budget.cancelled = options.cancelled;
  std::vector<std::optional<ModelStudyDraw>> draws(static_cast<std::size_t>(count));
  Mutex mutex;
  int done = block * count;
  for_each_index(count, options.threads, [&](int i) {
    if (is_cancelled()) return;
    const ModelDraw draw = drawn.at(i, budget);
    if (is_cancelled()) return;
    draws[static_cast<std::size_t>(i)] = closed_draw(draw, evaluate, options);
    const Lock lock(mutex);
    ++done;
    if (options.progress) options.progress(done, (block + 1) * count);
  });
  for (std::optional<ModelStudyDraw>& draw : draws)
    if (draw) all.push_back(*std::move(draw));
}

/// Weighs the draws by what was observed; whether they are enough.
bool weigh(ModelStudy& study) {
  std::vector<std::optional<ModelFigures>> figures;
  for (const ModelStudyDraw& draw : study.draws)
    figures.push_back(!draw.trusted            ? std::nullopt
                      : study.observed.empty() ? std::optional(ModelFigures{})
                                               : draw.figures);
  const Conditioning found = condition(study.observed, figures);
  for (std::size_t i = 0; i < study.draws.size(); ++i) study.draws[i].weight = found.weights[i];
  study.effective = found.effective;
  study.contradicts = found.contradicts;
  return found.effective >= kLeastEffective && !found.contradicts;
}

template <class Value>
std::optional<Interval> interval_over(const ModelStudy& study, const Value& value) {
  if (study.contradicts) return std::nullopt;
  std::vector<double> values, weights;
  for (const ModelStudyDraw& draw : study.draws) {
    if (!draw.trusted || !std::isfinite(value(draw))) continue;
    values.push_back(value(draw));
    weights.push_back(draw.weight);
  }
  return sampled_interval(values, weights);
}

}  // namespace

std::optional<Interval> tissue_interval(const ModelStudy& study) {
  return interval_over(study, [](const ModelStudyDraw& draw) { return draw.leak_mm2; });
}

std::optional<Interval> tissue_interval(const ModelStudy& study, std::size_t figure) {
  return interval_over(study, [=](const ModelStudyDraw& draw) { return draw.closed[figure]; });
}

std::vector<InformationRow> information_rows(const ModelStudy& study) {
  std::vector<InformedDraw> draws;
  for (const ModelStudyDraw& draw : study.draws)
    if (draw.trusted && draw.figures && draw.weight > 0.0)
      draws.push_back({draw.leak_mm2, draw.weight, draw.shares, *draw.figures, draw.closed_shape});
  return information_rows(draws, study.effective);
}

ModelStudy study_model(const Valve& valve, const ModelStudyOptions& options) {
  const Evaluator evaluate =
      options.evaluate ? options.evaluate : closing_evaluator({}, LeakBy::Surface);
  ModelStudy study;
  study.observed = valve.observed;
  study.draws_chordae = redraws_chordae(valve);
  study.draws_fit = valve.fitted.has_value();
  study.as_it_is =
      evaluate(options.plan == nullptr ? valve : *apply_plan(valve, *options.plan), nullptr)
          .evaluation;
  const auto [draws, blocks] = draw_blocks(study.observed, options.draws);
  for (int block = 0; block < blocks; ++block) {
    add_block(valve, block, draws, evaluate, options, study.draws);
    if (weigh(study) || (options.cancelled && options.cancelled())) break;
  }
  for (const ModelStudyDraw& draw : study.draws) study.untrusted += !draw.trusted;
  study.leak = uncertainty(study.as_it_is.measure.leak.area_mm2, study.draws);
  return study;
}

}  // namespace coapt
