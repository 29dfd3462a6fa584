// A haptic device as the loop sees it: a place comes in, a force goes out, once a period.
#pragma once

#include <functional>

#include "core/valve/types.h"

namespace coapt {

struct StylusState {
  Vec3 position_mm = Vec3::Zero();  ///< in the valve's frame, before --scale
  bool grabs = false;               ///< the button is down
  bool over = false;                ///< there is no more to come
};

/// Both are called by the loop alone and do not wait.
struct HapticDevice {
  /// An error where the device is lost.
  std::function<Expected<StylusState>(double time_ms)> read;
  /// On the hand, N.
  std::function<void(const Vec3& force_n)> show;
};

}  // namespace coapt
