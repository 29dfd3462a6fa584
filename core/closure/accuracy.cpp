#include "core/closure/accuracy.h"

#include <sstream>

namespace coapt {

const std::vector<AccuracyTier>& accuracy_tiers() {
  // Rounded up. One core of a shared Xeon of Sapphire Rapids class; all scenes converge uncrossed.
  static const std::vector<AccuracyTier> tiers = {
      {0.1, 0.4, {5.5, 11.0, 0.71}, {3.6, 9.5, 0.65}},
      {0.03, 0.12, {1.8, 7.0, 0.81}, {1.3, 2.8, 0.78}},
      {0.01, 0.04, {0.75, 1.3, 0.95}, {0.5, 0.94, 0.92}},
      {0.005, 0.02, {0.24, 1.1, 1.0}, {0.35, 0.67, 1.0}},
      {0.001, 0.01, {0.081, 0.71, 1.1}, {0.17, 0.68, 1.11}},
      {0.001, 0.004, {0.023, 0.7, 1.46}, {0.067, 0.27, 1.47}},
      {1e-4, 4e-4, {0.0087, 0.7, 1.9}, {0.0055, 0.13, 1.94}}};
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
  std::ostringstream message;
  message << "is " << orifice_mm2 << ", must be at least "
          << error_of(accuracy_tiers().back(), membrane).p99_mm2
          << " mm2, what the tightest tolerances keep in 99 of 100 scenes with membrane "
          << to_string(membrane);
  return Error{ErrorCode::OutOfRange, "/accuracy", message.str()};
}

ClosureOptions at_tier(ClosureOptions options, const AccuracyTier& tier) {
  options.residual_tolerance = tier.residual_tolerance;
  options.way_tolerance_mm = tier.way_tolerance_mm;
  return options;
}

}  // namespace coapt
