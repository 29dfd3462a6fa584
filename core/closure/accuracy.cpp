#include "core/closure/accuracy.h"

#include "core/valve/number_text.h"

namespace coapt {

const std::vector<AccuracyTier>& accuracy_tiers() {
  // Rounded up. Processor times of a loaded Xeon of Sapphire Rapids class; all scenes converge uncrossed. One of 300 ends in
  // another fold at the three loosest tolerances of the continuum and at the loosest of springs.
  static const std::vector<AccuracyTier> tiers = {
      {0.1, 0.4, {9.0, 21.0, 0.73}, {3.7, 22.0, 0.72}},
      {0.03, 0.12, {2.8, 3.7, 0.83}, {1.5, 22.0, 0.84}},
      {0.01, 0.04, {0.95, 1.5, 0.92}, {0.59, 22.0, 0.92}},
      {0.005, 0.02, {0.34, 0.57, 1.0}, {0.27, 0.65, 1.0}},
      {0.001, 0.01, {0.22, 0.26, 1.12}, {0.2, 0.31, 1.08}},
      {0.001, 0.004, {0.11, 0.22, 1.4}, {0.11, 0.44, 1.35}},
      {1e-4, 4e-4, {0.039, 0.28, 1.84}, {0.026, 0.11, 1.81}}};
  return tiers;
}

const TierError& error_of(const AccuracyTier& tier, Membrane membrane) {
  switch (membrane) {
    case Membrane::Springs:
      return tier.springs;
    case Membrane::Continuum:
      return tier.continuum;
  }
  return tier.springs;
}

Expected<AccuracyTier> choose_tier(double leak_mm2, Membrane membrane) {
  for (const AccuracyTier& tier : accuracy_tiers())
    if (error_of(tier, membrane).p99_mm2 <= leak_mm2) return tier;
  return Error{
      ErrorCode::OutOfRange, "/accuracy",
      "is " + shown(leak_mm2) + ", must be at least " +
          shown(error_of(accuracy_tiers().back(), membrane).p99_mm2) +
          " mm2, the error of the tightest tolerances in 99 of 100 test cases with membrane " +
          to_string(membrane)};
}

ClosureOptions at_tier(ClosureOptions options, const AccuracyTier& tier) {
  options.residual_tolerance = tier.residual_tolerance;
  options.way_tolerance_mm = tier.way_tolerance_mm;
  return options;
}

}  // namespace coapt
