// What a closure is made of, and how long each part takes (Google Benchmark). Whole closures run by both methods in the
// same process; `against_thesis` is how many times faster than method thesis on that valve, minutes
// before or after on the same machine. --benchmark_filter=REGEX picks some, --benchmark_format=json for scripts.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <map>
#include <vector>

#include "core/closure/closure.h"
#include "core/closure/moving_valve.h"
#include "core/metrics/leak_estimate.h"
#include "core/metrics/measure.h"
#include "core/presets/presets.h"
#include "lab/closures/varied_scenes.h"
#include "search/parallel.h"

namespace coapt {
namespace {

using Clock = std::chrono::steady_clock;

const Valve& valve(int triangles) {
  static std::map<int, Valve> valves;
  const auto found = valves.find(triangles);
  if (found != valves.end()) return found->second;
  return valves.emplace(triangles, *make_preset("human-normal", triangles)).first->second;
}

double seconds_of(const Valve& closed, const ClosureOptions& options) {
  const auto start = Clock::now();
  benchmark::DoNotOptimize(close_valve(closed, options));
  return std::chrono::duration<double>(Clock::now() - start).count();
}

double thesis_seconds(int triangles) {
  static std::map<int, double> known;
  const auto found = known.find(triangles);
  if (found != known.end()) return found->second;
  ClosureOptions thesis;
  thesis.method = Method::Thesis;
  std::vector<double> times;
  for (int k = 0; k < 3; ++k) times.push_back(seconds_of(valve(triangles), thesis));
  std::sort(times.begin(), times.end());
  return known.emplace(triangles, times[1]).first->second;
}

RelaxationSettings settings_for(const Valve& of) {
  RelaxationSettings settings;
  const double thickness = of.tissue.thickness_mm;
  settings.contact.thickness_mm = thickness;
  settings.contact.stiffness_n_per_mm4 =
      ClosureOptions{}.contact_pressure_mpa / (thickness * thickness);
  return settings;
}

/// A valve that has taken some steps: after 100 it is on the way, after 250 nearly closed.
struct Moving {
  ClosureModel model;
  RelaxationSettings settings;
  MovingValve<float> valve;

  Moving(const Valve& of, const RelaxationSettings& chosen, int steps)
      : model(make_closure_model(of)), settings(chosen), valve(model, settings, model.rest_mm) {
    valve.place_fixed(1.0);
    for (int s = 0; s < steps; ++s) valve.step(0.0);
  }
  explicit Moving(const benchmark::State& state)
      : Moving(coapt::valve(static_cast<int>(state.range(0))),
               settings_for(coapt::valve(static_cast<int>(state.range(0)))),
               static_cast<int>(state.range(1))) {}
};

void Model(benchmark::State& state) {
  const Valve& of = valve(static_cast<int>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(make_closure_model(of));
}

void Layout(benchmark::State& state) {
  const Valve& of = valve(static_cast<int>(state.range(0)));
  const ClosureModel model = make_closure_model(of);
  const RelaxationSettings settings = settings_for(of);
  for (auto _ : state) {
    MovingValve<float> moving(model, settings, model.rest_mm);
    benchmark::DoNotOptimize(&moving);
  }
}

void ListOfPairs(benchmark::State& state) {
  Moving moving(state);
  for (auto _ : state) moving.valve.list();
}

void LookForCrossings(benchmark::State& state) {
  Moving moving(state);
  for (auto _ : state) benchmark::DoNotOptimize(moving.valve.crossings());
}

/// Ten steps at a time from the same moment, lists of pairs included.
void time_steps(benchmark::State& state, MovingValve<float>& moving) {
  constexpr int kSteps = 10;
  const auto moment = moving.moment();
  for (auto _ : state) {
    moving.return_to(moment);
    for (int s = 0; s < kSteps; ++s) moving.step(0.0);
  }
  state.SetItemsProcessed(state.iterations() * kSteps);
}

void TenSteps(benchmark::State& state) {
  Moving moving(state);
  time_steps(state, moving.valve);
}

void TenStepsWithoutContact(benchmark::State& state) {
  const Valve& of = valve(static_cast<int>(state.range(0)));
  RelaxationSettings settings = settings_for(of);
  settings.contact.thickness_mm *= 1e-3;
  Moving moving(of, settings, static_cast<int>(state.range(1)));
  time_steps(state, moving.valve);
}

void Closure(benchmark::State& state, Method method) {
  const auto triangles = static_cast<int>(state.range(0));
  const double thesis = method == Method::Fast ? thesis_seconds(triangles) : 0.0;
  ClosureOptions options;
  options.method = method;
  double seconds = 0.0;
  for (auto _ : state) seconds += seconds_of(valve(triangles), options);
  if (method == Method::Fast)
    state.counters["against_thesis"] = thesis * static_cast<double>(state.iterations()) / seconds;
}

/// Varied scenes on several threads: closures a second in all.
void Batch(benchmark::State& state) {
  constexpr int kScenes = 64;
  std::vector<Valve> scenes;
  for (int i = 0; i < kScenes; ++i)
    scenes.push_back(varied_scene(valve(650), 1, i, SceneRings::None));
  for (auto _ : state)
    for_each_index(kScenes, static_cast<int>(state.range(0)), [&](int i) {
      benchmark::DoNotOptimize(close_valve(scenes[static_cast<std::size_t>(i)]));
    });
  state.SetItemsProcessed(state.iterations() * kScenes);
}

void WarmClosure(benchmark::State& state) {
  const Valve& of = valve(static_cast<int>(state.range(0)));
  const ClosureResult neighbour = close_valve(neighbour_of(of, 1, 0));
  for (auto _ : state) benchmark::DoNotOptimize(close_valve(of, {}, &neighbour));
}

void Measure(benchmark::State& state) {
  const Valve& of = valve(static_cast<int>(state.range(0)));
  const ClosureResult closed = close_valve(of);
  for (auto _ : state) benchmark::DoNotOptimize(measure(of, closed));
}

void LeakEstimate(benchmark::State& state) {
  const Valve& of = valve(static_cast<int>(state.range(0)));
  const ClosureResult closed = close_valve(of);
  for (auto _ : state) benchmark::DoNotOptimize(estimate_leak_mm2(of, closed.closed_mm));
}

const std::vector<std::int64_t> kMeshes = {650, 1300, 2600, 5200, 10400, 20000};  // triangles

BENCHMARK(Model)->Arg(650)->Arg(2600)->Unit(benchmark::kMicrosecond);
BENCHMARK(Layout)->ArgsProduct({kMeshes})->Unit(benchmark::kMicrosecond);
BENCHMARK(ListOfPairs)->ArgsProduct({kMeshes, {100, 250}})->Unit(benchmark::kMicrosecond);
BENCHMARK(LookForCrossings)->ArgsProduct({kMeshes, {250}})->Unit(benchmark::kMicrosecond);
BENCHMARK(TenSteps)->ArgsProduct({kMeshes, {100, 250}})->Unit(benchmark::kMicrosecond);
BENCHMARK(TenStepsWithoutContact)->ArgsProduct({kMeshes, {100}})->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(Closure, fast, Method::Fast)->Arg(650)->Arg(2600)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(Closure, thesis, Method::Thesis)->Arg(650)->Unit(benchmark::kMillisecond);
BENCHMARK(WarmClosure)->Arg(650)->Unit(benchmark::kMillisecond);
BENCHMARK(Batch)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(LeakEstimate)->Arg(650)->Arg(2600)->Unit(benchmark::kMicrosecond);
BENCHMARK(Measure)->Arg(650)->Arg(2600)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace coapt

BENCHMARK_MAIN();
