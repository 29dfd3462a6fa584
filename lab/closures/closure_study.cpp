#include "lab/closures/closure_study.h"

#include <cmath>
#include <mutex>
#include <numeric>
#include <optional>
#include <utility>

#include "core/closure/predicted_start.h"
#include "core/closure/prepared_valve.h"
#include "core/metrics/measure.h"
#include "core/metrics/quantile.h"
#include "lab/closures/closure_library.h"
#include "lab/closures/processor_time.h"
#include "lab/closures/varied_scenes.h"
#include "search/evaluator.h"
#include "search/parallel.h"

namespace coapt {
namespace {

constexpr double kOtherSpeed = 0.5;

/// The middle first, from which the others start.
std::vector<ClosureResult> close_frame(const PreparedValve& prepared, const SceneFrame& frame,
                                       const ClosureOptions& options) {
  std::vector<ClosureResult> closures;
  for (const Valve& valve : frame.valves)
    closures.push_back(
        close_valve(prepared, valve, options, closures.empty() ? nullptr : &closures[0]));
  return closures;
}

std::optional<ClosureResult> start_within(const Valve& scene, const SceneFrame& frame,
                                          const std::vector<ClosureResult>& closures) {
  const std::vector<double> shares = linear_shares(frame.moved_mm, frame.scene_mm);
  std::vector<ClosureShare> parts;
  for (std::size_t j = 0; j < shares.size(); ++j) parts.push_back({&closures[j], shares[j]});
  return predicted_start(scene.faces, parts);
}

constexpr std::uint64_t kOtherScenes = 1u << 20;  // apart from those of the study

struct TimedLibrary {
  ClosureLibrary library;
  double seconds = 0.0;
};

TimedLibrary library_of(const Valve& valve, const ClosureStudyOptions& options) {
  std::vector<Valve> scenes;
  for (int i = 0; i < options.library; ++i)
    scenes.push_back(varied_scene(valve, options.seed + kOtherScenes, i));
  std::vector<ClosureResult> closures(scenes.size());
  std::vector<double> seconds(scenes.size(), 0.0);
  for_each_index(options.library, options.threads, [&](int i) {
    const double before = processor_seconds();
    closures[i] = close_valve(scenes[i], options.closure);
    seconds[i] = processor_seconds() - before;
  });
  return {ClosureLibrary(scenes, std::move(closures)),
          std::accumulate(seconds.begin(), seconds.end(), 0.0)};
}

bool starts_from_others(const ClosureStudyOptions& options) {
  return options.warm || options.predicted || options.library > 0;
}

SceneOutcome close_scene(const Valve& scene, const ClosureStudyOptions& options,
                         const ClosureLibrary& library, int index) {
  SceneOutcome outcome;
  // Who closes neighbours has prepared their valve (searches, studies); cold closures prepare it.
  std::optional<PreparedValve> prepared;
  if (starts_from_others(options)) prepared.emplace(scene, options.closure);
  std::optional<ClosureResult> neighbour;
  SceneFrame frame;
  std::vector<ClosureResult> around;
  if (options.warm)
    neighbour = close_valve(*prepared, neighbour_of(scene, options.seed, index), options.closure);
  if (options.predicted) {
    frame = frame_of(scene, options.seed, index);
    const double before = processor_seconds();
    around = close_frame(*prepared, frame, options.closure);
    outcome.frame_seconds = processor_seconds() - before;
  }
  const double start = processor_seconds();
  if (options.predicted) {
    neighbour = start_within(scene, frame, around);
    outcome.predicted = neighbour.has_value();
    if (!neighbour) neighbour = around[0];
  }
  if (options.library > 0) {
    auto [closure, is_nearest] = library.start_of(scene);
    neighbour = std::move(closure);
    outcome.predicted = !is_nearest;
  }
  const ClosureResult* from = neighbour ? &*neighbour : nullptr;
  const ClosureResult closed = prepared ? close_valve(*prepared, scene, options.closure, from)
                                        : close_valve(scene, options.closure);
  outcome.seconds = processor_seconds() - start;
  outcome.status = closed.status;
  outcome.crossing = closed.crossing;
  outcome.steps = closed.steps;
  outcome.attempts = static_cast<int>(closed.attempts.size());
  if (!options.accuracy || !trusted(closed)) return outcome;
  ClosureOptions to_end = to_the_end(options.closure);
  const ClosureResult end = close_valve(scene, to_end, from);
  if (!starts_from_others(options)) to_end.speed *= kOtherSpeed;
  const ClosureResult other = close_valve(scene, to_end);
  outcome.compared = trusted(end) && trusted(other);
  if (!outcome.compared) return outcome;
  outcome.from_end = closure_error(scene, closed, end);
  outcome.from_other = closure_error(scene, end, other);
  outcome.other_equilibrium = outcome.from_other.rms_mm > kOtherEquilibrium_mm;
  return outcome;
}

}  // namespace

ClosureOptions to_the_end(ClosureOptions options) {
  options.residual_tolerance = 1e-6;
  options.way_tolerance_mm = 1e-4;
  options.max_steps = 100000;
  return options;
}

ClosureError closure_error(const Valve& valve, const ClosureResult& a, const ClosureResult& b) {
  const Eigen::VectorXd apart = (a.closed_mm - b.closed_mm).rowwise().norm();
  const ValveMeasure of_a = measure(valve, a), of_b = measure(valve, b);
  return {std::sqrt(apart.squaredNorm() / static_cast<double>(apart.size())), apart.maxCoeff(),
          of_a.leak.area_mm2 - of_b.leak.area_mm2,
          of_a.coaptation.height_mean_mm - of_b.coaptation.height_mean_mm};
}

ClosureStudy study_closures(const std::vector<Valve>& valves, const ClosureStudyOptions& options,
                            const std::function<void(int)>& progress) {
  ClosureStudy study;
  study.scenes.resize(static_cast<std::size_t>(options.count));
  std::vector<TimedLibrary> libraries;
  for (const Valve& valve : valves) libraries.push_back(library_of(valve, options));
  for (const TimedLibrary& library : libraries) study.library_seconds += library.seconds;
  std::mutex mutex;
  int done = 0;
  for_each_index(options.count, options.threads, [&](int i) {
    const std::size_t of = static_cast<std::size_t>(i) % valves.size();
    study.scenes[static_cast<std::size_t>(i)] =
        close_scene(varied_scene(valves[of], options.seed, i), options, libraries[of].library, i);
    const std::lock_guard<std::mutex> lock(mutex);
    if (progress) progress(++done);
  });
  std::vector<double> ms, steps, leak_differences = {0.0};
  double seconds = 0.0, frame_seconds = 0.0;
  for (const SceneOutcome& scene : study.scenes) {
    ms.push_back(1e3 * scene.seconds);
    steps.push_back(scene.steps);
    seconds += scene.seconds;
    frame_seconds += scene.frame_seconds;
    study.not_predicted += (options.predicted || options.library > 0) && !scene.predicted;
    study.unconverged += scene.status != ClosureStatus::Converged;
    study.crossed += scene.crossing;
    study.retried += scene.attempts > 1;
    if (!scene.compared) continue;
    ++study.compared;
    study.other_equilibria += scene.other_equilibrium;
    leak_differences.push_back(std::abs(scene.from_other.leak_mm2));
  }
  study.closures_per_second_per_core = seconds > 0.0 ? options.count / seconds : 0.0;
  study.frames_per_second_per_core = frame_seconds > 0.0 ? options.count / frame_seconds : 0.0;
  study.median_ms = quantile(ms, 0.5);
  study.p90_ms = quantile(ms, 0.9);
  study.median_steps = quantile(steps, 0.5);
  study.leak_difference_p90_mm2 = quantile(leak_differences, 0.9);
  study.leak_difference_max_mm2 = quantile(leak_differences, 1.0);
  return study;
}

}  // namespace coapt
