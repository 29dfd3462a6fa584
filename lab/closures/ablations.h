// What the model of a closure consists of, each ingredient taken away, replaced or made finer.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "core/closure/closure.h"
#include "core/valve/valve.h"

namespace coapt {

/// What makes a scene again at any resolution.
struct AblationScene {
  std::string preset;
  int variation = -1;      ///< index for varied_scene() without rings; -1: the preset itself
  std::uint64_t seed = 1;  ///< likewise
  int triangles = 650;
};

/// "human-normal", "human-normal/2".
std::string name_of(const AblationScene& scene);
Valve make_scene(const AblationScene& scene);

/// What is closed, and how.
struct AblatedModel {
  Valve valve;
  ClosureOptions closure;
  bool mean_of_samples = false;  ///< of the end states, instead of the first
};

struct Ablation {
  std::string group, change;
  /// From the full model of the scene.
  std::function<AblatedModel(AblatedModel, const AblationScene&)> apply;
};

/// Grouped: tissue, membrane and mesh, chordae, contact, annulus, the end; last what the others are to
/// be read against.
const std::vector<Ablation>& ablations();

/// Each branched chorda replaced by straight ones to its insertions: as taut in the valve's closed state
/// with annulus and tips where they rest, and together as stiff.
Valve with_straight_chordae(const Valve& valve);

}  // namespace coapt
