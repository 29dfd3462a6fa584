// A haptic device as the loop sees it: a place comes in, a force goes out, once a period.
#pragma once

#include <functional>

#include "core/valve/types.h"

namespace coapt {

/// A coordinate of a stylus in its own frame is at most this far from 0; what is farther is no hand's place.
inline constexpr double kFarthest_mm = 1000.0;

struct StylusState {
  Vec3 position_mm = Vec3::Zero();  ///< in the valve's frame, before --scale
  bool grabs = false;               ///< the button is down
  bool over = false;                ///< there is no more to come
  bool fresh = true;                ///< came since the last call; if not, all is as it was then
};

/// Both are called by the loop alone and do not wait.
struct HapticDevice {
  /// An error where the device is lost.
  std::function<Expected<StylusState>(double time_ms)> read;
  /// On the hand, N: once for each fresh state, and zero at the end.
  std::function<void(const Vec3& force_n)> show;
};

}  // namespace coapt
