#include "core/closure/accuracy.h"

#include <sstream>

namespace coapt {

const std::vector<AccuracyTier>& accuracy_tiers() {
  // Rounded up. One core of a shared Xeon of Sapphire Rapids class; all scenes converge uncrossed.
  static const std::vector<AccuracyTier> tiers = {
      {0.1, 0.4, {3.2, 4.5, 0.73}, {3.4, 4.2, 0.68}},
      {0.03, 0.12, {1.0, 1.5, 0.85}, {0.75, 1.1, 0.79}},
      {0.01, 0.04, {0.47, 0.91, 0.94}, {0.34, 0.82, 0.89}},
      {0.005, 0.02, {0.22, 0.8, 1.0}, {0.22, 0.6, 1.0}},
      {0.001, 0.01, {0.053, 0.19, 1.11}, {0.048, 0.6, 1.06}},
      {0.001, 0.004, {0.018, 0.037, 1.37}, {0.021, 0.16, 1.3}},
      {1e-4, 4e-4, {0.0043, 0.006, 1.73}, {0.0047, 0.0065, 1.7}}};
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
