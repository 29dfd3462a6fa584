#include "core/metrics/measure.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "core/metrics/closed_figures.h"
#include "core/metrics/leak_estimate.h"
#include "tests/scenes/sheets.h"

namespace coapt {
namespace {

TEST(Measure, PutsThePartsTogether) {
  const Valve valve = disc_with_hole(15.0, 3.0);
  ClosureResult closure = closed_at_rest(valve);
  closure.closed_mm.col(1) *= 1.1;
  closure.samples_mm.clear();
  const ValveMeasure result = measure(valve, closure);
  EXPECT_NEAR(result.leak.area_mm2, std::numbers::pi * 2.5 * 2.8, 0.5);
  EXPECT_EQ(result.leak.openings.size(), 1U);
  EXPECT_NEAR(result.annulus.ap_mm, 30.0, 1e-9);
  EXPECT_NEAR(result.strain_radial_max, 0.105, 1e-9);
  EXPECT_NEAR(result.strain_circumferential_max, 0.0, 1e-9);
  EXPECT_NEAR(result.tenting_height_mm, 0.0, 1e-9);
  EXPECT_EQ(result.tension_max_n, 0.0);
  // From the hole's anterior end, (0, 3.3), to where the posterior side begins, (3, 0).
  EXPECT_NEAR(result.coaptation.distance_max_mm, std::hypot(3.0, 3.3), 0.01);
}

TEST(Measure, OfPointsThatAreNotFiniteOnlyTheAnnulusIsKnown) {
  const Valve valve = disc_with_hole(15.0, 3.0);
  ClosureResult closure = closed_at_rest(valve);
  closure.closed_mm(200, 1) = std::numeric_limits<double>::quiet_NaN();
  const ValveMeasure result = measure(valve, closure);
  EXPECT_NEAR(result.annulus.ap_mm, 30.0, 1e-9);
  EXPECT_TRUE(std::isnan(result.leak.area_mm2));
  EXPECT_TRUE(std::isnan(result.coaptation.height_mean_mm));
  EXPECT_FALSE(result.coaptation.sections[4].contact);
}

TEST(Measure, OfClosuresThatNobodySeesTheLeakIsEstimated) {
  const Valve valve = disc_with_hole(15.0, 3.0);
  const ClosureResult closure = closed_at_rest(valve);
  const ValveMeasure result = measure(valve, closure, LeakBy::Estimate);
  EXPECT_EQ(result.leak.area_mm2, estimate_leak_mm2(valve, closure.closed_mm));
  EXPECT_TRUE(result.leak.openings.empty());
  EXPECT_TRUE(std::isnan(result.leak.lower_mm2));
  EXPECT_EQ(result.coaptation.height_mean_mm, measure(valve, closure).coaptation.height_mean_mm);
}

TEST(Measure, RepeatsItselfToTheBit) {
  const Valve valve = disc_with_hole(15.0, 3.0);
  const ClosureResult closure = closed_at_rest(valve);
  const ValveMeasure first = measure(valve, closure), second = measure(valve, closure);
  EXPECT_EQ(first.leak.area_mm2, second.leak.area_mm2);
  EXPECT_EQ(first.coaptation.height_mean_mm, second.coaptation.height_mean_mm);
  EXPECT_EQ(first.tenting_area_mm2, second.tenting_area_mm2);
}

TEST(ClosedFigures, HaveTheMeshsErrorWhereTheClosureIsToBeTrusted) {
  ValveMeasure measure;
  measure.coaptation.sections[3].height_mm = 3.0;
  measure.coaptation.sections[4].height_mm = 4.0;
  measure.coaptation.sections[5].height_mm = 8.0;
  measure.tension_max_n = 2.0;
  measure.strain_circumferential_max = 0.2;
  measure.strain_radial_max = 0.5;
  const auto estimates = closed_estimates(measure, 325);  // half as many: twice the error
  EXPECT_EQ(closed_figures_of(measure)[0], 5.0);
  EXPECT_EQ(estimates[0].value, 5.0);
  EXPECT_NEAR(estimates[0].numerical->high, 6.8, 1e-12);
  EXPECT_NEAR(estimates[1].numerical->low, 1.72, 1e-12);
  EXPECT_NEAR(estimates[3].numerical->high, 0.236, 1e-12);
  EXPECT_NEAR(estimates[4].numerical->high, 0.56, 1e-12);
  EXPECT_STREQ(closed_figures()[2].name, "leaflet_ratio");
  EXPECT_TRUE(std::isnan(estimates[2].value)) << "the leaflets do not touch";
  EXPECT_FALSE(estimates[2].numerical);
  measure.anterior_length_mm = 20.0;
  measure.posterior_length_mm = 10.0;
  EXPECT_NEAR(closed_estimates(measure, 650)[2].numerical->low, 1.9, 1e-12);
  EXPECT_FALSE(closed_estimates(measure, 0)[1].numerical);
}

}  // namespace
}  // namespace coapt
