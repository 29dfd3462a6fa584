#include "core/closed/accurate_closure.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/scenes/small_preset.h"

namespace coapt {
namespace {

TEST(AccurateClosure, RefinesUntilTheLeakIsKnownSoWell) {
  const Valve& valve = small_preset("human-functional-mr");
  const ClosedValve coarse = close_and_measure(valve);
  const double wanted_mm2 = 0.6 * coarse.measure.leak_error_mm2;
  const Expected<AccurateClosure> accurate = close_within(valve, wanted_mm2, {});
  ASSERT_TRUE(accurate);
  EXPECT_LE(accurate->closed.measure.leak_error_mm2, wanted_mm2);
  EXPECT_EQ(accurate->closed.valve.faces.rows(), valve.faces.rows() << (2 * accurate->refinements));
  EXPECT_GE(accurate->refinements, 1);
  EXPECT_EQ(close_within(valve, 1e3, {})->refinements, 0);
}

TEST(AccurateClosure, WhatNoMeshKeepsIsAnErrorBeforeAnyFineClosure) {
  const Valve& valve = small_preset("human-functional-mr");
  for (const double wanted : {0.3, 1e-4, 0.0, -1.0, std::numeric_limits<double>::quiet_NaN()}) {
    const Expected<AccurateClosure> accurate = close_within(valve, wanted, {}, 1000);
    ASSERT_FALSE(accurate) << wanted;
    EXPECT_EQ(accurate.errors().front().code, ErrorCode::OutOfRange);
    EXPECT_EQ(accurate.errors().front().path, "/accuracy");
    EXPECT_NE(accurate.errors().front().message.find("must be at least"), std::string::npos);
  }
}

}  // namespace
}  // namespace coapt
