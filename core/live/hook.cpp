#include "core/live/hook.h"

#include <algorithm>

namespace coapt {

Vec3 pull_n(const Hook& hook, const Vec3& spot_mm, const HookLimits& limits) {
  if (hook.constant_n) return *hook.constant_n;
  const Vec3 pull = limits.stiffness_n_per_mm * (hook.hook_mm - spot_mm);
  const double size = pull.norm();
  return size > limits.largest_n ? Vec3(pull * (limits.largest_n / size)) : pull;
}

void approach_hand(Hook& hook, const HookLimits& limits) {
  const Vec3 way = hook.hand_mm - hook.hook_mm;
  hook.hook_mm += std::min(1.0, limits.longest_move_mm / std::max(way.norm(), 1e-12)) * way;
}

}  // namespace coapt
