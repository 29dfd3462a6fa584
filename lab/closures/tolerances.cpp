// The table of core/closure/accuracy.cpp: error of the leak and time of closures at each tier's
// tolerances, over varied scenes of five presets. Prints CSV: membrane, residual tolerance, way
// tolerance, scenes compared, |error| median, 90 %, 99 % and largest (mm2), time over that of the default.
// Usage: tolerances [SCENES_OF_EACH_PRESET [TRIANGLES]]   (default 60 and the preset's own number; about
// eight minutes of processor time)

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "core/closure/accuracy.h"
#include "core/metrics/leak.h"
#include "core/metrics/quantile.h"
#include "core/presets/presets.h"
#include "io/json/plan_json.h"
#include "lab/closures/closure_study.h"
#include "lab/closures/processor_time.h"
#include "lab/closures/varied_scenes.h"
#include "search/evaluator.h"
#include "search/parallel.h"

namespace {

using namespace coapt;

constexpr std::uint64_t kSeed = 11;

struct Outcome {
  bool compared = false;
  double error_mm2 = 0.0, seconds = 0.0;
};

/// One for each tier.
std::vector<Outcome> close_at_tiers(const Valve& valve, const ClosureOptions& options) {
  const ClosureResult end = close_valve(valve, to_the_end(options));
  const double truth = measure_leak(valve, end.closed_mm).area_mm2;
  std::vector<Outcome> outcomes;
  for (const AccuracyTier& tier : accuracy_tiers()) {
    const double start = processor_seconds();
    const ClosureResult closed = close_valve(valve, at_tier(options, tier));
    const double seconds = processor_seconds() - start;
    outcomes.push_back({trusted(end) && trusted(closed),
                        measure_leak(valve, closed.closed_mm).area_mm2 - truth, seconds});
  }
  return outcomes;
}

void print(const std::vector<std::vector<Outcome>>& scenes, Membrane membrane) {
  const ClosureOptions plain;
  std::vector<double> seconds(accuracy_tiers().size(), 0.0);
  double plain_seconds = 0.0;
  for (std::size_t t = 0; t < seconds.size(); ++t) {
    for (const auto& scene : scenes) seconds[t] += scene[t].seconds;
    if (accuracy_tiers()[t].residual_tolerance == plain.residual_tolerance)
      plain_seconds = seconds[t];
  }
  for (std::size_t t = 0; t < seconds.size(); ++t) {
    std::vector<double> errors;
    for (const auto& scene : scenes)
      if (scene[t].compared) errors.push_back(std::abs(scene[t].error_mm2));
    const AccuracyTier& tier = accuracy_tiers()[t];
    std::printf("%s,%g,%g,%zu,%.3g,%.3g,%.3g,%.3g,%.2f\n", to_string(membrane),
                tier.residual_tolerance, tier.way_tolerance_mm, errors.size(),
                quantile(errors, 0.5), quantile(errors, 0.9), quantile(errors, 0.99),
                quantile(errors, 1.0), seconds[t] / plain_seconds);
  }
}

}  // namespace

int main(int argc, char** argv) {
  const int count = argc > 1 ? std::atoi(argv[1]) : 60;
  const int triangles = argc > 2 ? std::atoi(argv[2]) : 0;
  std::vector<Valve> presets;
  for (const char* name :
       {"human-normal", "human-functional-mr", "human-p2-prolapse", "porcine-1", "porcine-5"})
    presets.push_back(*make_preset(name, triangles));
  const int scenes = count * static_cast<int>(presets.size());
  std::printf("membrane,residual,way_mm,scenes,median,p90,p99,max,time\n");
  for (const Membrane membrane : {Membrane::Springs, Membrane::Continuum}) {
    std::vector<std::vector<Outcome>> outcomes(static_cast<std::size_t>(scenes));
    for_each_index(scenes, 0, [&](int i) {
      const Valve& preset = presets[static_cast<std::size_t>(i / count)];
      outcomes[static_cast<std::size_t>(i)] =
          close_at_tiers(varied_scene(preset, kSeed, i % count), {.membrane = membrane});
    });
    print(outcomes, membrane);
    std::fflush(stdout);
  }
}
