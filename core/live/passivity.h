// Keeps a haptic hand from being fed energy: a passivity observer and controller in the time domain.
//
// A force that is computed from samples comes late, and a spring that is late gives back more than was put into it: the stylus
// buzzes. The observer adds up what the hand has put in since it took hold (Hannaford and Ryu 2002, IEEE Trans Robot Autom 18:1,
// eq. 4). The device holds a force until the next sample, so the sum of force times way is exact (Ryu, Preusche, Hannaford and
// Hirzinger 2005, IEEE Trans Control Syst Technol 13:365), however late the force was. Where their controller adds damping once
// energy is missing, this one shows less of the force beforehand, as much as the next way of the hand could not turn into a gain,
// in the manner of energy bounding (Kim and Ryu 2010, Int J Robot Res 29:666): a hand goes on as it goes, give or take what it
// can accelerate in a period.
//
// Limits: an account starts with a credit, without which a hand at rest would never feel anything; once that much was earned it
// is gone, and the balance stays above zero from then on. A hand that accelerates more than the limit, or a period that lasts
// longer than was said, can take more than there is; then nothing but forces that resist are shown until it is paid back. What
// happens between this force and the motors (transport, the device's own controller) is not seen.
#pragma once

#include "core/valve/types.h"

namespace coapt {

struct PassivityLimits {
  double acceleration_mm_per_ms2 = 0.05;  ///< of the hand, at most: 50 m/s2, five times gravity
  double credit_mj = 0.001;               ///< 0.01 N over 0.1 mm, far below what can be felt
  double resistance_n_per_mm = 0.5;       ///< per mm of the last period's way, while in debt
  double largest_resistance_n = 0.5;
};

/// From one grasp to its end.
struct PassivityAccount {
  bool begun = false;
  bool earned = false;          ///< its credit, some time
  Vec3 hand_mm = Vec3::Zero();  ///< at the last sample
  Vec3 shown_n = Vec3::Zero();  ///< on the hand since then
  double energy_mj = 0.0;       ///< that the hand has put in
  double lowest_mj = 0.0;       ///< of it so far
};

/// What the hand has done since the last sample, with the force that was shown meanwhile.
void observe(PassivityAccount& account, const Vec3& hand_mm);

/// Observes, and returns what to show on the hand from now on for `period_ms`: `wanted_n`, or less of it. The next sample must
/// be a new one, no later than that: a place that is only repeated hides what the hand does meanwhile.
Vec3 passive_force_n(PassivityAccount& account, const Vec3& hand_mm, const Vec3& wanted_n,
                     double period_ms, const PassivityLimits& limits = {});

}  // namespace coapt
