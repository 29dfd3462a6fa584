// Closing a valve: from its unstressed shape to rest under systolic pressure, with self-contact.
#pragma once

#include <string>
#include <vector>

#include "core/closure/membrane.h"
#include "core/closure/self_contact.h"
#include "core/valve/valve.h"

namespace coapt {

/// Fast: relaxation in single precision, SIMD (relaxation.h). Thesis: its reference (thesis.h).
enum class Method { Fast, Thesis };
enum class ClosureStatus { Converged, StepLimit, Diverged };

/// End states that the thesis takes the mean of (4.2.1).
inline constexpr int kThesisSamples = 5;

struct ClosureOptions {
  Method method = Method::Fast;
  Membrane membrane = Membrane::Springs;
  double residual_tolerance = 0.005;  ///< rms free force / rms pressure force
  double way_tolerance_mm = 0.02;     ///< Fast: predicted rms way of the leaflets to rest
  int max_steps =
      0;  ///< of one relaxation, of which an attempt of Fast is one or two, at last four; 0:
          ///< 6,000, for the patient attempt 20,000 (Fast), 40,000 (Thesis)
  double contact_pressure_mpa =
      0.74;                     ///< between leaflets at distance 0; it grows with the square of the
                                ///< approach, from 0 where mid-surfaces are a thickness apart
  double speed = 1.0;           ///< of moves, (0, 1]: less is slower and takes another way to rest
  double damping_per_ms = 1.0;  ///< Thesis: velocities decay by exp(-damping t)
  int samples = 1;              ///< closely spaced end states recorded
  bool edge_contact = false;    ///< in the first attempt already (always from the open state);
                                ///< else only where leaflets would cross
  SelfContact self_contact = SelfContact::All;
  bool motion = false;  ///< Fast: keep the states on the way (ClosureResult::motion_mm)
};

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
  ClosureStatus status = ClosureStatus::StepLimit;
  Points closed_mm;                ///< |V| x 3, order of Valve::rest_mm
  std::vector<Points> samples_mm;  ///< end states, the first equals closed_mm; at least one
  /// Where asked for: from where the attempt started to closed_mm, 15 steps apart. Rows: the vertices, the branch points
  /// (in the order of chordae and of their segments that do not insert), the heads. The way to rest is
  /// not that of real time.
  std::vector<Points> motion_mm;
  std::vector<std::vector<double>> tension_n;  ///< [chorda][segment], >= 0
  std::vector<Points> branch_points_mm;        ///< [chorda]: one row per segment: its far end
  double residual = 0.0;
  int steps = 0;          ///< of all attempts
  bool crossing = false;  ///< some leaflet triangle passes through another, or Diverged
  int crossing_pairs = 0;
  std::vector<int> guarded_faces;        ///< Fast: whose edges have contact, too (relaxation.h)
  std::vector<ClosureAttempt> attempts;  ///< in the order tried; the result is the best of them
};

/// Deterministic: the same valve and options give the same bits, on any instruction set. Never throws
/// on a valid valve.
/// `neighbour`: a closure of a valve with the same mesh, for a warm start of method fast: from there, its
/// annulus travelling to this valve's. What comes of it may be another equilibrium than from the open
/// state. If it does not converge uncrossed, or the neighbour did not, the closure starts from the open state.
/// @pre validate(valve) is empty; the neighbour's valve has the same faces.
ClosureResult close_valve(const Valve& valve, const ClosureOptions& options = {},
                          const ClosureResult* neighbour = nullptr);

const char* to_string(Method method);
const char* to_string(ClosureStatus status);

}  // namespace coapt
