// A hand of random pulls, jerks and pinches on live valves: where each ends when let go, against the cold closure.
// Usage: random_hand [PULLS] [PRESET...]   (of each preset, default 1,000 of all; 20 min on one core)
// Prints CSV, a line a preset: rms to the closure with the usual tolerances and with a thirtieth of them (median, p90, largest,
// mm), how often the valve went back because leaflets would have crossed, states shown and those with a crossing (all are
// tested), pulls after which the valve did not come to rest, steps until it did (median, largest), microseconds a step.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <string>
#include <vector>

#include "core/closure/closure.h"
#include "core/closure/crossing.h"
#include "core/live/live_valve.h"
#include "core/presets/presets.h"
#include "search/random_share.h"

namespace {

using namespace coapt;
using Clock = std::chrono::steady_clock;

constexpr int kMostSteps = 30000;  // until a valve that is let go must be at rest

struct Tally {
  std::vector<double> usual_mm, tight_mm, settle_steps;
  long shown = 0, crossed = 0, steps = 0;
  int restless = 0;
  double seconds = 0.0;
};

double at_share(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

class RandomHand {
 public:
  explicit RandomHand(const Valve& valve)
      : valve_(valve), live_(valve, kMmhgPerKpa * valve.pressure_kpa), engine_(1) {
    ClosureOptions options;
    usual_mm_ = close_valve(valve, options).closed_mm;
    options.residual_tolerance *= 0.03;
    options.way_tolerance_mm *= 0.03;
    tight_mm_ = close_valve(valve, options).closed_mm;
    settle();
    tally_ = {};
  }

  /// A pull, a jerk in six directions or a pinch with two hooks, in turn.
  void pull(int kind) {
    const bool jerk = kind % 3 == 1;
    const int hooks = kind % 3 == 2 ? 2 : 1;
    for (int h = 0; h < hooks; ++h) take_hold(h);
    for (int move = 0; move < (jerk ? 6 : 2); ++move) {
      for (int h = 0; h < hooks; ++h)
        live_.move_to(h, live_.spot_mm(h) + (jerk ? 25.0 : 12.0) * random_way());
      for (int k = 0; k < 5; ++k) advance();
    }
    for (int h = 0; h < hooks; ++h) live_.release(h);
    tally_.settle_steps.push_back(settle());
    tally_.usual_mm.push_back(rms_mm(usual_mm_));
    tally_.tight_mm.push_back(rms_mm(tight_mm_));
  }

  const Tally& tally() const { return tally_; }
  int returns() const { return live_.returns(); }

 private:
  void take_hold(int hook) {
    if (random_share(engine_) < 0.2) {
      const auto cables = static_cast<double>(live_.cables().size());
      live_.grab_cable(hook, static_cast<int>(cables * random_share(engine_)), 0.5);
    } else {
      live_.grab(hook, static_cast<int>(live_.vertices() * random_share(engine_)));
    }
  }

  Vec3 random_way() {
    const double x = random_share(engine_), y = random_share(engine_), z = random_share(engine_);
    return 2.0 * Vec3(x, y, z) - Vec3::Ones();
  }

  void advance() {
    const auto start = Clock::now();
    live_.advance(60);
    tally_.seconds += std::chrono::duration<double>(Clock::now() - start).count();
    tally_.steps += 60;
    ++tally_.shown;
    if (!crossing_pairs(valve_.faces, leaflets_mm()).empty()) ++tally_.crossed;
  }

  int settle() {
    int steps = 0;
    for (; steps < kMostSteps && !live_.at_rest(); steps += 60) advance();
    if (!live_.at_rest()) ++tally_.restless;
    return steps;
  }

  Points leaflets_mm() const { return live_.vertices_mm().topRows(live_.vertices()); }
  double rms_mm(const Points& other_mm) const {
    return std::sqrt((leaflets_mm() - other_mm).squaredNorm() / live_.vertices());
  }

  const Valve& valve_;
  LiveValve live_;
  std::mt19937_64 engine_;
  Points usual_mm_, tight_mm_;
  Tally tally_;
};

void print(const std::string& preset, const RandomHand& hand) {
  const Tally& t = hand.tally();
  const auto count = static_cast<int>(t.usual_mm.size());
  std::printf("%s,%d,%.4f,%.4f,%.4f,%.4f,%.4f,%.4f,%d,%ld,%ld,%d,%.0f,%.0f,%.1f\n", preset.c_str(),
              count, at_share(t.usual_mm, 0.5), at_share(t.usual_mm, 0.9),
              at_share(t.usual_mm, 1.0), at_share(t.tight_mm, 0.5), at_share(t.tight_mm, 0.9),
              at_share(t.tight_mm, 1.0), hand.returns(), t.shown, t.crossed, t.restless,
              at_share(t.settle_steps, 0.5), at_share(t.settle_steps, 1.0),
              1e6 * t.seconds / static_cast<double>(t.steps));
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  const int pulls = argc > 1 ? std::atoi(argv[1]) : 1000;
  const std::vector<std::string> presets =
      argc > 2 ? std::vector<std::string>(argv + 2, argv + argc) : preset_names();
  if (pulls < 1) {
    std::fprintf(stderr, "usage: random_hand [PULLS] [PRESET...]\n");
    return 2;
  }
  std::puts(
      "preset,pulls,rms_median_mm,rms_p90_mm,rms_largest_mm,tight_median_mm,tight_p90_mm,"
      "tight_largest_mm,returns,shown,crossed,restless,settle_median_steps,settle_largest_steps,"
      "us_per_step");
  for (const std::string& preset : presets) {
    const Expected<Valve> valve = make_preset(preset);
    if (!valve) {
      std::fprintf(stderr, "random_hand: %s\n", valve.errors().front().message.c_str());
      return 2;
    }
    RandomHand hand(*valve);
    for (int i = 0; i < pulls; ++i) hand.pull(i);
    print(preset, hand);
  }
  return 0;
}
