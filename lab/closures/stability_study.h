// Where each method of closing holds and where it fails: a map over axes of difficulty.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/closure/contact.h"
#include "core/closure/model.h"
#include "core/closure/run.h"
#include "lab/closures/stability_scenes.h"

namespace coapt {

/// A closure is at rest at this residual, whatever the method; half as much more is granted when it is
/// measured again at its end, which lies a step behind the state that some methods judged.
inline constexpr double kStabilityResidual = 0.01;

struct AttemptSettings {
  double step = 1.0;  ///< factor on the method's own step
  ContactLaw contact;
};

/// One attempt, from the unstressed shape, without a second try.
struct StabilityMethod {
  std::string name;
  std::function<ClosureRun(const ClosureModel&, const AttemptSettings&)> close;
  int most_triangles = 0;  ///< finer levels are left out; 0: none
  Membrane membrane = Membrane::Continuum;
};

/// From best to worst.
enum class StabilityOutcome {
  Settles,           ///< uncrossed
  OtherEquilibrium,  ///< settles uncrossed, but carried to its end not where the reference ends
  Crosses,           ///< settles, with leaflets through each other
  Stalls,            ///< its steps were used up, or it gave up
  BlowsUp,           ///< a node was lost
};

struct StabilityCell {
  std::string scene, method;
  Difficulty axis = Difficulty::Step;
  double level = 1.0;
  bool nominal = false;
  StabilityOutcome outcome = StabilityOutcome::Stalls;
  int steps = 0, attempts = 1;
  double seconds = 0.0;
  double residual = 0.0;  ///< of the end, in double precision
  int crossing_pairs = 0;
  /// What follows is NaN unless the closure settled uncrossed and the scene has a reference: distance of
  /// the answer from the reference and, if that is far, of the answer carried to residual 1e-6.
  double from_reference_mm = 0.0, end_from_reference_mm = 0.0;  ///< rms
  double leak_difference_mm2 = 0.0;
};

struct StabilityStudyOptions {
  std::vector<std::string> scenes = {"human-normal", "porcine-1", kCommissures};
  std::vector<DifficultyAxis> axes = difficulty_axes();  ///< each holds its nominal level
  int threads = 0;  ///< 0: all cores; does not change the map, but its times
};

/// Methods `thesis`, then `comparators`, then the relaxation in single precision: `fast (springs)`, `unguarded`, `fast` and `preconditioned`
/// (by the stiffness of the leaflets as a whole), then `coapt`: close_valve() with its defaults, which has no step to vary. In order of
/// scene, axis, method, level. The reference of a scene is `fast` on the method's membrane, carried to residual 1e-6 in double.
/// `progress`: levels done and planned; from several threads, one at a time.
std::vector<StabilityCell> study_stability(const StabilityStudyOptions& options,
                                           const std::vector<StabilityMethod>& comparators,
                                           const std::function<void(int, int)>& progress = {});

const char* to_string(StabilityOutcome outcome);

}  // namespace coapt
