// What a closure is asked for: method, membrane, tolerances.
#pragma once

#include <functional>
#include <limits>

#include "core/closure/membrane.h"
#include "core/closure/self_contact.h"

namespace coapt {

/// Fast: relaxation in single precision, SIMD (relaxation.h). Thesis: its reference (thesis.h).
enum class Method { Fast, Thesis };

const char* to_string(Method method);

/// End states that the thesis takes the mean of (4.2.1).
inline constexpr int kThesisSamples = 5;

/// What a closure may cost. One that ends within it has the same bits as without.
struct ClosureBudget {
  /// Steps times vertices, of all attempts.
  double vertex_steps = std::numeric_limits<double>::infinity();
  /// Asked every 15 or 20 steps, on the thread that closes; true ends the closure. Empty: nobody asks.
  std::function<bool()> cancelled{};

  bool is_cancelled() const { return cancelled && cancelled(); }
};

struct ClosureOptions {
  Method method = Method::Fast;
  Membrane membrane = Membrane::Continuum;
  double residual_tolerance = 0.005;  ///< rms free force / rms pressure force
  /// Fast: predicted rms displacement of the leaflets that remains until rest.
  double way_tolerance_mm = 0.02;
  /// Of one relaxation; an attempt of Fast is one or two, the last four. 0: 6,000, on meshes finer than
  /// 2,600 triangles in proportion to their number across, for the patient attempt 20,000 (Fast),
  /// 40,000 (Thesis).
  int max_steps = 0;
  /// Between leaflets at distance 0; it grows with the square of the approach, from 0 where
  /// mid-surfaces are a thickness apart.
  double contact_pressure_mpa = 0.74;
  double speed = 1.0;           ///< of moves, (0, 1]: less is slower and takes another way to rest
  double damping_per_ms = 1.0;  ///< Thesis: velocities decay by exp(-damping t)
  int samples = 1;              ///< closely spaced end states recorded
  /// In the first attempt already (always from the open state); else only where leaflets would
  /// cross.
  bool edge_contact = false;
  SelfContact self_contact = SelfContact::All;
  bool motion = false;  ///< Fast: keep the states on the way (ClosureResult::motion_mm)
  ClosureBudget budget{};
};

}  // namespace coapt
