#include "search/studies/model_study.h"

#include <algorithm>
#include <limits>
#include <mutex>
#include <optional>
#include <utility>

#include "core/metrics/mean_and_sd.h"
#include "core/metrics/quantile.h"
#include "search/model_draw.h"
#include "search/parallel.h"

namespace coapt {
namespace {

ModelUncertainty uncertainty(double as_it_is_mm2, const std::vector<ModelStudyDraw>& draws) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  ModelUncertainty found{as_it_is_mm2, nan, nan, nan, nan, {}};
  std::vector<std::vector<double>> shares;
  std::vector<double> areas;
  for (const ModelStudyDraw& draw : draws) {
    if (!draw.trusted) continue;
    shares.push_back(draw.shares);
    areas.push_back(draw.leak_mm2);
  }
  if (areas.empty()) return found;
  const auto [mean, sd] = mean_and_sd(areas);
  found.mean_mm2 = mean;
  found.sd_mm2 = sd;
  found.decided_by = sobol_indices(shares, areas);
  found.p5_mm2 = quantile(areas, 0.05);
  found.p95_mm2 = quantile(areas, 0.95);
  return found;
}

}  // namespace

ModelStudy study_model(const Valve& valve, const ModelStudyOptions& options) {
  const Evaluator evaluate =
      options.evaluate ? options.evaluate : closing_evaluator({}, LeakBy::Surface);
  const std::vector<std::vector<double>> shares = model_draws(options.draws, options.seed);
  std::vector<std::optional<ModelStudyDraw>> draws(shares.size());
  ModelStudy study;
  study.as_it_is = evaluate(valve, nullptr).evaluation;
  std::mutex mutex;
  int done = 0;
  for_each_index(options.draws, options.threads, [&](int i) {
    if (options.cancelled != nullptr && options.cancelled->load()) return;
    ModelStudyDraw draw{shares[i], false, 0.0};
    if (const Expected<Valve> drawn = with_model(valve, shares[i])) {
      const Evaluation evaluation = evaluate(*drawn, nullptr).evaluation;
      draw.trusted = trusted(evaluation);
      draw.leak_mm2 = evaluation.measure.leak.area_mm2;
    }
    draws[i] = std::move(draw);
    const std::lock_guard<std::mutex> lock(mutex);
    ++done;
    if (options.progress) options.progress(done, options.draws);
  });
  for (std::optional<ModelStudyDraw>& draw : draws)
    if (draw) {
      study.untrusted += !draw->trusted;
      study.draws.push_back(*std::move(draw));
    }
  study.leak = uncertainty(study.as_it_is.measure.leak.area_mm2, study.draws);
  return study;
}

}  // namespace coapt
