// Closing a valve: from its unstressed shape to rest under systolic pressure, with self-contact.
#pragma once

#include <vector>

#include "core/valve/valve.h"

namespace coapt {

enum class Method { Thesis };
enum class ClosureStatus { Converged, StepLimit, Diverged };

struct ClosureOptions {
  Method method = Method::Thesis;
  double residual_tolerance = 0.01;  ///< rms free force / rms pressure force
  int max_steps = 40000;
  double contact_thickness_mm = 1.0;  ///< distance of leaflet mid-surfaces at first touch
  double contact_stiffness_n_per_mm4 =
      0.74;                     ///< contact pressure = stiffness x (thickness - distance)^2
  double damping_per_ms = 1.0;  ///< velocities decay by exp(-damping t); 0.5 to 1 settles fastest
  int samples = 5;              ///< end states recorded (thesis 4.2.1)
  double sample_interval_ms = 0.5;
};

/// All points are in the valve's frame, in millimetres.
struct ClosureResult {
  ClosureStatus status = ClosureStatus::StepLimit;
  Points closed_mm;                ///< |V| x 3, order of Valve::rest_mm
  std::vector<Points> samples_mm;  ///< closely spaced end states, the first equals closed_mm
  std::vector<std::vector<double>> tension_n;  ///< [chorda][segment], >= 0
  std::vector<Points> branch_points_mm;        ///< [chorda]: one row per segment: its far end
  double residual = 0.0;
  int steps = 0;
  bool crossing = false;  ///< some leaflet triangle passes through another
  int crossing_pairs = 0;
};

/// Deterministic: the same valve and options give the same bits. Never throws on a valid valve.
/// @pre validate(valve) is empty.
ClosureResult close_valve(const Valve& valve, const ClosureOptions& options = {});

const char* to_string(Method method);
const char* to_string(ClosureStatus status);

}  // namespace coapt
