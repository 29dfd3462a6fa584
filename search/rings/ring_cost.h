// What a ring's design minimises: the share of valves that it leaves leaking, over members and disturbances, smoothed so that an
// optimiser sees a slope, and what it costs beside.
#pragma once

#include <vector>

#include "search/rings/ring_trial.h"

namespace coapt {

/// All assumed: a valve that it leaves narrow, or an annulus made smaller than practice accepts, counts as one that leaks; the rest only
/// decides among rings that are equal in that.
struct RingWeights {
  double narrow = 1.0;          ///< share of members with a mean gradient above kStenosis_mmhg
  double undersized = 1.0;      ///< share of members with more than kMostSizesBelow sizes taken
  double leak_per_mm2 = 0.005;  ///< of the mean leak, each counted up to kMostLeak_mm2
  double suture_per_n = 0.02;   ///< of the mean over members of the largest pull at a suture
  double durability_per_mm =
      0.01;  ///< of what a member does not last of kFurthestCourse_mm, where it was asked
};

/// Of the leak in RingWeights::leak_per_mm2; a closure that cannot be trusted counts as so much.
inline constexpr double kMostLeak_mm2 = 100.0;

/// A member's leak is below kMildLeak_mm2: 1 or 0, smoothed over 1.5 mm2; of a closure that cannot be trusted 0.
double smooth_share_below(double leak_mm2);

/// Lower is better. Of one outcome; that of a ring is the mean over its members.
double ring_cost(const RingOutcome& outcome, const RingWeights& weights = {});
double ring_cost(const std::vector<RingOutcome>& outcomes, const RingWeights& weights = {});

/// Share of an outcome's closures that are trusted and leak less than kMildLeak_mm2.
double share_below(const RingOutcome& outcome);
/// Mean of its leaks, each up to kMostLeak_mm2.
double mean_leak_mm2(const RingOutcome& outcome);

}  // namespace coapt
