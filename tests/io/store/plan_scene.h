// Closures of plans by number, and whether two are the same.
#pragma once

#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <string>

#include "io/store/plan_store.h"

namespace coapt {

/// Fifteen disturbances to a plan, all rows different, not in the order of the store's key.
inline std::string numbered_plan(int i) {
  return "suture anterolateral trigone " + std::to_string((i / 15 * 7919) % 10'007);
}

inline int numbered_disturbance(int i) { return 14 - i % 15; }

inline PlanClosure numbered_closure(int i) {
  return {.status = static_cast<ClosureStatus>(i % 3),
          .crossing = i % 2 == 0,
          .leak_mm2 = i / 3.0,
          .coaptation_mm = -i / 9.0,
          .distance_max_mm = i / 11.0,
          .tension_max_n = i / 13.0,
          .leaflet_ratio = i / 17.0};
}

inline Errors keep_numbered(PlanStore& store, const std::string& subject, int i) {
  return store.keep(subject, numbered_plan(i), numbered_disturbance(i), numbered_closure(i));
}

/// Bit for bit.
inline void expect_same(const PlanClosure& a, const PlanClosure& b) {
  const auto expect_same_bits = [](double x, double y) {
    EXPECT_EQ(std::bit_cast<std::uint64_t>(x), std::bit_cast<std::uint64_t>(y)) << x << ' ' << y;
  };
  EXPECT_EQ(a.status, b.status);
  EXPECT_EQ(a.crossing, b.crossing);
  expect_same_bits(a.leak_mm2, b.leak_mm2);
  expect_same_bits(a.coaptation_mm, b.coaptation_mm);
  expect_same_bits(a.distance_max_mm, b.distance_max_mm);
  expect_same_bits(a.tension_max_n, b.tension_max_n);
  expect_same_bits(a.leaflet_ratio, b.leaflet_ratio);
}

inline int closures_in(const KnownPlans& known) {
  std::size_t closures = 0;
  for (const auto& [key, of_plan] : known) closures += of_plan.size();
  return static_cast<int>(closures);
}

}  // namespace coapt
