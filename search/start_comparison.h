// Whether what closures start from decides where they end: closures from predicted starts
// (core/closure/predicted_start.h) beside others of the same valves from the open state.
//
// A folded leaflet may come to rest in more than one way. Predicted starts keep all closures near the
// ones that they are predicted from; how many of them a cold start would lead elsewhere says how
// much hangs on that.
#pragma once

#include <span>

#include "core/closure/closure_result.h"

namespace coapt {

/// Rms distance of the leaflets from which on two closures count as different. Each may be 0.03 mm
/// from its own end.
inline constexpr double kElsewhere_mm = 0.1;

/// Of a sample.
struct StartCheck {
  int closures = 0;   ///< trusted both ways
  int elsewhere = 0;  ///< of these
  double leak_difference_max_mm2 = 0.0;
};

/// Of one valve, closed and trusted both ways.
StartCheck compare_ends(const ClosureResult& predicted, const ClosureResult& cold,
                        double leak_difference_mm2);

StartCheck united(std::span<const StartCheck> checks);

}  // namespace coapt
