// What each ingredient of the model buys, in leak and shape, and what it costs in time.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "lab/closures/ablations.h"

namespace coapt {

/// Scenes: each preset as it is, and `variations` dilated and displaced ones of it.
struct AblationStudyOptions {
  std::vector<std::string> presets = {"human-normal", "human-functional-mr", "human-p2-prolapse",
                                      "porcine-1"};
  int variations = 3;
  std::uint64_t seed = 1;
  int triangles = 650;  ///< of the full model
  int repeats = 3;      ///< of each pair of timed closures
};

/// One changed closure against that of the full model: the change is the first less the second.
struct AblationOutcome {
  std::string group, change, scene;
  ClosureStatus status = ClosureStatus::StepLimit;
  bool crossing = false;
  int attempts = 0;
  bool compared = false;  ///< both closures are converged and uncrossed
  double full_leak_mm2 = 0.0,
         leak_change_mm2 = 0.0;  ///< of the least surface (core/metrics/leak.h)
  double rms_mm = 0.0;           ///< between the leaflets, at the vertices of the full model
  double seconds = 0.0;          ///< processor time of the changed closure, reruns included
  double time_ratio = 0.0;       ///< to a closure of the full model right before, median
};

/// In order of scene, then of ablations(). `progress`: done and planned.
std::vector<AblationOutcome> study_ablations(const AblationStudyOptions& options,
                                             const std::function<void(int, int)>& progress = {});

}  // namespace coapt
