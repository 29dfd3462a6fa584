#include "core/live/passivity.h"

#include <algorithm>

namespace coapt {
namespace {

constexpr double kSpentShare = 0.99;  // of what was earned, at most: from nothing, nothing grows

}  // namespace

void observe(PassivityAccount& account, const Vec3& hand_mm) {
  if (account.begun) account.energy_mj -= account.shown_n.dot(hand_mm - account.hand_mm);
  account.lowest_mj = std::min(account.lowest_mj, account.energy_mj);
  account.hand_mm = hand_mm;
  account.begun = true;
}

Vec3 passive_force_n(PassivityAccount& account, const Vec3& hand_mm, const Vec3& wanted_n,
                     double period_ms, const PassivityLimits& limits) {
  const Vec3 way_mm = account.begun ? Vec3(hand_mm - account.hand_mm) : Vec3(Vec3::Zero());
  observe(account, hand_mm);
  const double swerve_mm = limits.acceleration_mm_per_ms2 * period_ms * period_ms;
  account.earned = account.earned || account.energy_mj >= limits.credit_mj;
  const double reserve_mj =
      account.earned ? kSpentShare * account.energy_mj : account.energy_mj + limits.credit_mj;
  if (reserve_mj > 0.0) {
    // The most that the hand can gain by this force in the next period.
    const double gain_mj = wanted_n.dot(way_mm) + wanted_n.norm() * swerve_mm;
    account.shown_n = gain_mj > reserve_mj ? Vec3(wanted_n * (reserve_mj / gain_mj)) : wanted_n;
  } else if (const double way = way_mm.norm(); way > swerve_mm) {
    // A hand this fast cannot turn round in a period, so that resisting it can only earn.
    account.shown_n =
        -std::min(limits.largest_resistance_n, limits.resistance_n_per_mm * way) * (way_mm / way);
  } else {
    account.shown_n.setZero();
  }
  return account.shown_n;
}

}  // namespace coapt
