#include "core/closure/accuracy.h"

#include <sstream>

namespace coapt {

const std::vector<AccuracyTier>& accuracy_tiers() {
  // Rounded up. One core of a shared Xeon of Sapphire Rapids class; all scenes converge uncrossed.
  static const std::vector<AccuracyTier> tiers = {
      {0.1, 0.4, {5.6, 12.0, 0.74}, {4.1, 9.5, 0.66}},
      {0.03, 0.12, {2.0, 12.0, 0.84}, {1.3, 2.7, 0.79}},
      {0.01, 0.04, {0.81, 1.4, 0.93}, {0.5, 0.94, 0.93}},
      {0.005, 0.02, {0.36, 1.3, 1.0}, {0.35, 0.67, 1.0}},
      {0.001, 0.01, {0.17, 0.7, 1.12}, {0.17, 0.68, 1.14}},
      {0.001, 0.004, {0.026, 0.7, 1.47}, {0.062, 0.26, 1.51}},
      {1e-4, 4e-4, {0.0055, 0.7, 1.82}, {0.0056, 0.12, 2.13}}};
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
