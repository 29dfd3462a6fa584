#include "lab/closures/ablation_study.h"

#include <algorithm>
#include <cmath>

#include "core/metrics/leak.h"
#include "core/metrics/quantile.h"
#include "lab/closures/matching_points.h"
#include "lab/closures/processor_time.h"
#include "search/evaluator.h"

namespace coapt {
namespace {

constexpr double kOnce_seconds = 0.5;  // longer closures are timed once

struct Closed {
  AblatedModel model;
  ClosureResult closure;
  double leak_mm2 = 0.0;
};

Closed close(const AblatedModel& model) {
  Closed closed{model, close_valve(model.valve, model.closure), 0.0};
  if (!model.mean_of_samples) {
    closed.leak_mm2 = measure_leak(model.valve, closed.closure.closed_mm).area_mm2;
    return closed;
  }
  Points mean = Points::Zero(closed.closure.closed_mm.rows(), 3);
  for (const Points& sample : closed.closure.samples_mm) {
    mean += sample;
    closed.leak_mm2 += measure_leak(model.valve, sample).area_mm2 /
                       static_cast<double>(closed.closure.samples_mm.size());
  }
  closed.closure.closed_mm = mean / static_cast<double>(closed.closure.samples_mm.size());
  return closed;
}

double seconds_of(const AblatedModel& model) {
  const double start = processor_seconds();
  close_valve(model.valve, model.closure);
  return processor_seconds() - start;
}

void time_closures(const AblatedModel& full, const AblatedModel& changed, int repeats,
                   AblationOutcome& outcome) {
  std::vector<double> seconds, ratios;
  do {
    const double of_full = seconds_of(full);
    seconds.push_back(seconds_of(changed));
    ratios.push_back(seconds.back() / of_full);
  } while (seconds.back() < kOnce_seconds && static_cast<int>(seconds.size()) < repeats);
  outcome.seconds = quantile(seconds, 0.5);
  outcome.time_ratio = quantile(ratios, 0.5);
}

double rms_apart_mm(const Closed& full, const Closed& changed) {
  const Valve& valve = full.model.valve;
  const Points there = changed.model.valve.rest_mm.rows() == valve.rest_mm.rows()
                           ? changed.closure.closed_mm
                           : matching_points_mm(valve, {changed.model.valve,
                                                        leaflet_coordinates(changed.model.valve),
                                                        changed.closure.closed_mm});
  return std::sqrt((full.closure.closed_mm - there).rowwise().squaredNorm().mean());
}

AblationOutcome compare(const Closed& full, const Ablation& ablation, const AblationScene& scene,
                        int repeats) {
  const AblatedModel model = ablation.apply(full.model, scene);
  const Closed changed = close(model);
  AblationOutcome outcome;
  outcome.group = ablation.group;
  outcome.change = ablation.change;
  outcome.scene = name_of(scene);
  outcome.status = changed.closure.status;
  outcome.crossing = changed.closure.crossing;
  outcome.attempts = static_cast<int>(changed.closure.attempts.size());
  outcome.compared = trusted(full.closure) && trusted(changed.closure);
  outcome.full_leak_mm2 = full.leak_mm2;
  outcome.leak_change_mm2 = changed.leak_mm2 - full.leak_mm2;
  outcome.rms_mm = rms_apart_mm(full, changed);
  time_closures(full.model, model, repeats, outcome);
  return outcome;
}

}  // namespace

std::vector<AblationOutcome> study_ablations(const AblationStudyOptions& options,
                                             const std::function<void(int, int)>& progress) {
  std::vector<AblationScene> scenes;
  for (const std::string& preset : options.presets)
    for (int variation = -1; variation < options.variations; ++variation)
      scenes.push_back({preset, variation, options.seed, options.triangles});
  const int planned = static_cast<int>(scenes.size() * ablations().size());
  std::vector<AblationOutcome> outcomes;
  for (const AblationScene& scene : scenes) {
    const Closed full = close({make_scene(scene), {}, false});
    for (const Ablation& ablation : ablations()) {
      outcomes.push_back(compare(full, ablation, scene, options.repeats));
      if (progress) progress(static_cast<int>(outcomes.size()), planned);
    }
  }
  return outcomes;
}

}  // namespace coapt
