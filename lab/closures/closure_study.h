// How fast and how true closures are, over many scenes of valves.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "core/closure/closure.h"
#include "core/repair/annuloplasty.h"

namespace coapt {

/// Rms distance of two ends from which on they count as different equilibria.
inline constexpr double kOtherEquilibrium_mm = 0.05;

struct ClosureStudyOptions {
  ClosureOptions closure;
  int count = 100;         ///< scenes
  std::uint64_t seed = 1;  ///< of varied_scene
  int threads = 0;         ///< 0: all cores
  bool accuracy = true;    ///< also close each scene to the end, and once more on another way
  bool warm = false;       ///< close each scene from the closure of a neighbour (neighbour_of)
  bool predicted = false;  ///< or from what those around it let expect (frame_of)
  int library = 0;  ///< or from so many other scenes of its valve (closure_library.h); 0: not
};

/// Distances over the leaflet vertices.
struct ClosureError {
  double rms_mm = 0.0, max_mm = 0.0;
  double leak_mm2 = 0.0;              ///< of the least surface (core/metrics/leak.h)
  double coaptation_height_mm = 0.0;  ///< of the mean
};

struct SceneOutcome {
  ClosureStatus status = ClosureStatus::StepLimit;
  bool crossing = false;
  int steps = 0, attempts = 0;
  /// Processor time of the closure, reruns and crossing tests included.
  double seconds = 0.0;
  /// Predicted: of the closures that it was predicted from, one from the open state, six from that.
  double frame_seconds = 0.0;
  /// Else from the frame's middle, or the library's nearest: the frame or the prediction failed.
  bool predicted = false;
  bool compared = false;    ///< the closures compared with have converged uncrossed, too
  ClosureError from_end;    ///< from the same closure carried on to residual 1e-6 in double
  ClosureError from_other;  ///< of that end from the end of a closure at half the speed; warm and
                            ///< predicted: from the end of a cold start
  bool other_equilibrium = false;  ///< the two ends are more than 0.05 mm rms apart
};

struct ClosureStudy {
  std::vector<SceneOutcome> scenes;
  double closures_per_second_per_core = 0.0;
  double median_ms = 0.0, p90_ms = 0.0;
  int unconverged = 0, crossed = 0, retried = 0;
  int compared = 0, other_equilibria = 0;
  /// Of the two ends of each scene, absolute.
  double leak_difference_p90_mm2 = 0.0, leak_difference_max_mm2 = 0.0;
  double median_steps = 0.0;
  int not_predicted = 0;                    ///< of all scenes; 0 where none was to be
  double frames_per_second_per_core = 0.0;  ///< 0 without
  double library_seconds = 0.0;             ///< processor time of all libraries' closures
};

/// The end of such a closure: to residual 1e-6 and 1e-4 mm of predicted way.
ClosureOptions to_the_end(ClosureOptions closure);

/// Error of closure `a` against closure `b` of the same valve.
ClosureError closure_error(const Valve& valve, const ClosureResult& a, const ClosureResult& b);

/// Closes varied scenes, one of each valve in turn. `progress` is called with the number of scenes done, from several
/// threads, one at a time. All but the times is the same for any number of threads.
ClosureStudy study_closures(const std::vector<Valve>& valves, const ClosureStudyOptions& options,
                            const std::function<void(int)>& progress = {});

}  // namespace coapt
