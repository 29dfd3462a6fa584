// How unique the closed state is: the same scenes closed at full and at half the speed, with leaflets
// that resist bending more and more.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "lab/closures/closure_study.h"

namespace coapt {

struct UniquenessStudyOptions {
  std::vector<std::string> presets = {"human-normal", "human-functional-mr", "human-p2-prolapse",
                                      "porcine-1", "porcine-4"};
  int scenes = 25;  ///< varied ones (varied_scenes.h) of each preset at `seed`, as many at seed + 1
  int anatomies = 60;  ///< that no preset resembles, one varied scene of each
  std::uint64_t seed = 5;
  std::vector<double> bending_n_mm = {0.0, 0.001, 0.003, 0.01, 0.03, 0.1};
  Membrane membrane = Membrane::Continuum;
  int threads = 0;  ///< 0: all cores
};

/// One scene at one rigidity.
struct UniquenessPoint {
  /// Where the scene comes from: "known" scenes have seed 5, by which the model was looked at while it
  /// was made (docs/experiments.md); "new" ones another; "anatomies" are no presets.
  std::string kind;
  std::string valve;
  std::uint64_t seed = 0;
  int scene = 0;  ///< index of varied_scene()
  double bending_n_mm = 0.0;
  SceneOutcome outcome;
};

/// In order of rigidity, then of kind, valve and scene. Chordae are as long as they are at the preset's
/// own rigidity. The same for any number of threads but for the times. `progress`: scenes done and planned.
std::vector<UniquenessPoint> study_uniqueness(const UniquenessStudyOptions& options,
                                              const std::function<void(int, int)>& progress = {});

/// Columns: kind, valve, seed, scene, bending_n_mm, status, crossing, attempts, steps, compared, rms_mm,
/// leak_difference_mm2: half speed's end against that at full speed; empty where they do not compare.
std::string uniqueness_csv(const std::vector<UniquenessPoint>& points);

}  // namespace coapt
