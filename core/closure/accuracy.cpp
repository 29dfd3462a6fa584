#include "core/closure/accuracy.h"

#include "core/valve/number_text.h"

namespace coapt {

const std::vector<AccuracyTier>& accuracy_tiers() {
  // Rounded up. One core of a quiet EPYC of Zen 4 class; all scenes converge uncrossed. In one of 500 the continuum's
  // tightest tolerances end in another equilibrium.
  static const std::vector<AccuracyTier> tiers = {
      {0.1, 0.4, {3.1, 3.7, 0.75}, {3.7, 5.2, 0.74}},
      {0.03, 0.12, {1.1, 1.6, 0.85}, {0.82, 1.2, 0.85}},
      {0.01, 0.04, {0.31, 0.87, 0.94}, {0.37, 0.94, 0.94}},
      {0.005, 0.02, {0.18, 0.87, 1.0}, {0.23, 0.35, 1.0}},
      {0.001, 0.01, {0.048, 0.18, 1.09}, {0.062, 0.38, 1.09}},
      {0.001, 0.004, {0.016, 0.024, 1.38}, {0.018, 0.38, 1.36}},
      {1e-4, 4e-4, {0.0042, 0.0071, 1.67}, {0.0054, 0.38, 1.7}}};
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

Expected<AccuracyTier> choose_tier(double orifice_mm2, Membrane membrane) {
  for (const AccuracyTier& tier : accuracy_tiers())
    if (error_of(tier, membrane).p99_mm2 <= orifice_mm2) return tier;
  return Error{ErrorCode::OutOfRange, "/accuracy",
               "is " + shown(orifice_mm2) + ", must be at least " +
                   shown(error_of(accuracy_tiers().back(), membrane).p99_mm2) +
                   " mm2, what the tightest tolerances keep in 99 of 100 scenes with membrane " +
                   to_string(membrane)};
}

ClosureOptions at_tier(ClosureOptions options, const AccuracyTier& tier) {
  options.residual_tolerance = tier.residual_tolerance;
  options.way_tolerance_mm = tier.way_tolerance_mm;
  return options;
}

}  // namespace coapt
