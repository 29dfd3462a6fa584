// What a closure gives: its status, the closed shape and what the chordae carry.
#pragma once

#include <string>
#include <vector>

#include "core/closure/closure_options.h"
#include "core/valve/types.h"

namespace coapt {

enum class ClosureStatus { Converged, StepLimit, Diverged };

const char* to_string(ClosureStatus status);

/// One rung of the ladder that close_valve climbs until a closure is converged and uncrossed.
struct ClosureAttempt {
  std::string how;  ///< for instance "float, edge contact"
  ClosureStatus status = ClosureStatus::StepLimit;
  int crossing_pairs = 0;
  double residual = 0.0;
  int steps = 0;
};

/// All points are in the valve's frame, in millimetres.
struct ClosureResult {
  Method method = Method::Fast;
  Membrane membrane = Membrane::Springs;
  double residual_tolerance = 0.0, way_tolerance_mm = 0.0;  ///< that were asked for
  ClosureStatus status = ClosureStatus::StepLimit;
  Points closed_mm;                ///< |V| x 3, order of Valve::rest_mm
  std::vector<Points> samples_mm;  ///< end states, the first equals closed_mm; at least one
  /// Where asked for: from where the attempt started to closed_mm, 15 steps apart. Rows: the
  /// vertices, the branch points (in the order of chordae and of their segments that do not
  /// insert), the heads. The way to rest is not that of real time.
  std::vector<Points> motion_mm;
  std::vector<std::vector<double>> tension_n;  ///< [chorda][segment], >= 0
  std::vector<double> tie_tension_n;           ///< [tie], >= 0
  std::vector<Points> branch_points_mm;        ///< [chorda]: one row per segment: its far end
  double residual = 0.0;
  int steps = 0;          ///< of all attempts
  bool crossing = false;  ///< some leaflet triangle passes through another, or Diverged
  int crossing_pairs = 0;
  std::vector<int> guarded_faces;        ///< Fast: whose edges have contact, too (relaxation.h)
  std::vector<ClosureAttempt> attempts;  ///< in the order tried; the result is the best of them
  bool predicted = false;   ///< no closure, but where one is expected to end (predicted_start.h)
  bool unfinished = false;  ///< the budget was spent or the closure cancelled: not all was tried
};

/// Converged, without leaflets through each other.
inline bool trusted(const ClosureResult& closure) {
  return closure.status == ClosureStatus::Converged && !closure.crossing;
}

}  // namespace coapt
