// A nerve hook on a valve that moves: a spring from the hand to a spot of the tissue, whose pull is bounded, so that no hand can
// tear a leaflet through another.
#pragma once

#include <optional>
#include <vector>

#include "core/closure/insertion_zone.h"

namespace coapt {

struct HookLimits {
  double stiffness_n_per_mm = 0.5;  ///< of the spring
  double largest_n = 3.0;           ///< of its pull
  double longest_move_mm = 0.1;     ///< of the hook towards the hand, in one step of the valve
};

/// The tip of a hook: a disc of this radius holds to the leaflet.
inline constexpr double kHookRadius_mm = 1.5;

struct Hook {
  std::vector<NodeShare> shares;  ///< nodes that it holds; weights sum to 1
  Vec3 hand_mm = Vec3::Zero();    ///< where the hand wants it
  Vec3 hook_mm = Vec3::Zero();    ///< where it is: on its way to the hand
  /// In place of the spring, N: the hand is somewhere along this.
  std::optional<Vec3> constant_n{};
};

/// What the hook pulls with when the spot that it holds is at `spot_mm`, N.
Vec3 pull_n(const Hook& hook, const Vec3& spot_mm, const HookLimits& limits);

/// The hook a step nearer to the hand.
void approach_hand(Hook& hook, const HookLimits& limits);

}  // namespace coapt
