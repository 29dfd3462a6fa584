#include "core/closure/accuracy.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/closure/closure.h"
#include "core/metrics/leak.h"
#include "core/presets/presets.h"

namespace coapt {
namespace {

constexpr std::array kMembranes = {Membrane::Springs, Membrane::Continuum};

TEST(AccuracyTiers, ErrorsFallAndTimesRiseFromTierToTier) {
  const std::vector<AccuracyTier>& tiers = accuracy_tiers();
  for (std::size_t t = 1; t < tiers.size(); ++t) {
    EXPECT_LE(tiers[t].residual_tolerance, tiers[t - 1].residual_tolerance);
    EXPECT_LT(tiers[t].way_tolerance_mm, tiers[t - 1].way_tolerance_mm);
    for (const Membrane membrane : kMembranes) {
      const TierError &tier = error_of(tiers[t], membrane),
                      &before = error_of(tiers[t - 1], membrane);
      EXPECT_LT(tier.p99_mm2, before.p99_mm2);
      EXPECT_LE(tier.p99_mm2, tier.max_mm2);
      EXPECT_GT(tier.relative_time, before.relative_time);
    }
  }
}

TEST(AccuracyTiers, EachIsChosenByItsOwnErrorAndTheCheapestByAnyLargerOne) {
  for (const Membrane membrane : kMembranes)
    for (const AccuracyTier& tier : accuracy_tiers()) {
      const Expected<AccuracyTier> chosen = choose_tier(error_of(tier, membrane).p99_mm2, membrane);
      ASSERT_TRUE(chosen);
      EXPECT_EQ(chosen->way_tolerance_mm, tier.way_tolerance_mm);
    }
  EXPECT_EQ(choose_tier(1e6, Membrane::Springs)->residual_tolerance,
            accuracy_tiers().front().residual_tolerance);
}

TEST(AccuracyTiers, WhatNoTierKeepsIsAnErrorThatNamesTheRange) {
  for (const double wanted : {0.001, 0.0, -1.0, std::numeric_limits<double>::quiet_NaN()}) {
    const Expected<AccuracyTier> chosen = choose_tier(wanted, Membrane::Springs);
    ASSERT_FALSE(chosen) << wanted;
    EXPECT_EQ(chosen.errors().front().code, ErrorCode::OutOfRange);
    EXPECT_EQ(chosen.errors().front().path, "/accuracy");
    EXPECT_NE(chosen.errors().front().message.find("must be at least 0.039 mm2"), std::string::npos)
        << chosen.errors().front().message;
  }
}

TEST(AccuracyTiers, TheDefaultTolerancesAreOneOfThem) {
  const ClosureOptions plain = at_tier({}, *choose_tier(0.34, Membrane::Springs));
  EXPECT_EQ(plain.residual_tolerance, ClosureOptions{}.residual_tolerance);
  EXPECT_EQ(plain.way_tolerance_mm, ClosureOptions{}.way_tolerance_mm);
  EXPECT_EQ(error_of(*choose_tier(0.34, Membrane::Springs), Membrane::Springs).relative_time, 1.0);
}

TEST(AccuracyTiers, KeepWhatTheyPromiseOnPresets) {
  for (const char* name : {"human-normal", "human-functional-mr", "porcine-5"}) {
    const Valve valve = *make_preset(name);
    const auto leak = [&](const ClosureOptions& options) {
      return measure_leak(valve, close_valve(valve, options).closed_mm).area_mm2;
    };
    const double end =
        leak({.residual_tolerance = 1e-6, .way_tolerance_mm = 1e-4, .max_steps = 100000});
    for (const AccuracyTier& tier : accuracy_tiers())
      EXPECT_NEAR(leak(at_tier({}, tier)), end, tier.continuum.max_mm2) << name;
  }
}

}  // namespace
}  // namespace coapt
