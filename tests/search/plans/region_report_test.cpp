#include "search/plans/region_report.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace coapt {
namespace {

constexpr double kTolerance = 1e-10;

PlanClosure leaking(double leak_mm2) {
  PlanClosure closure;
  closure.leak_mm2 = leak_mm2;
  return closure;
}

PlanClosure failed() {
  PlanClosure closure;
  closure.crossing = true;
  return closure;
}

/// A plan whose whole region leaks by a function of the steps from the middle: length in -4..4,
/// outwards and posterior in -5..5.
template <class LeakAt>
PlanRecord whole_region(const LeakAt& leak_at) {
  PlanRecord plan;
  for (int l = -4; l <= 4; ++l)
    for (int o = -5; o <= 5; ++o)
      for (int p = -5; p <= 5; ++p)
        plan.closures[region_node(l + 4, o + 5, p + 5)] = leaking(leak_at(l, o, p));
  return plan;
}

double quadratic(int l, int o, int p) { return 50.0 + 3.0 * l + o * o + 0.3 * l * p; }

void expect_unknown(const LeakStatistics& statistics) {
  for (const double value : {statistics.mean, statistics.sd, statistics.p95, statistics.worst,
                             statistics.below_5, statistics.below_10, statistics.below_20})
    EXPECT_TRUE(std::isnan(value));
}

TEST(RegionReport, StatisticsOfTheLeaks0To20) {
  // Mean 10, variance (21^2 - 1) / 12; the 95 % quantile of 21 values is the 20th.
  PlanRecord plan;
  for (int d = 0; d <= 20; ++d) plan.closures[d] = leaking(20.0 - d);
  const RegionReport report = region_report(plan, kRegion.count);
  EXPECT_EQ(report.closures, 21);
  EXPECT_EQ(report.failures, 0);
  EXPECT_EQ(report.leak_mm2.nominal, 20.0);
  EXPECT_NEAR(report.leak_mm2.mean, 10.0, kTolerance);
  EXPECT_NEAR(report.leak_mm2.sd, std::sqrt(440.0 / 12.0), kTolerance);
  EXPECT_NEAR(report.leak_mm2.p95, 19.0, kTolerance);
  EXPECT_EQ(report.leak_mm2.worst, 20.0);
  EXPECT_NEAR(report.leak_mm2.below_5, 5.0 / 21.0, kTolerance);
  EXPECT_NEAR(report.leak_mm2.below_10, 10.0 / 21.0, kTolerance);
  EXPECT_NEAR(report.leak_mm2.below_20, 20.0 / 21.0, kTolerance);
}

TEST(RegionReport, OnlyTheNodesThatCountAreCounted) {
  PlanRecord plan;
  for (int d = 0; d < 20; ++d) plan.closures[d] = leaking(d < 5 ? 2.0 * d : 100.0);
  const RegionReport report = region_report(plan, 5);
  EXPECT_EQ(report.closures, 5);
  EXPECT_NEAR(report.leak_mm2.mean, 4.0, kTolerance);
  EXPECT_EQ(report.leak_mm2.worst, 8.0);
}

TEST(RegionReport, FailedNodesAreCountedAndLeftOut) {
  PlanRecord plan;
  plan.closures = {{0, leaking(1.0)}, {1, failed()}, {2, leaking(3.0)}};
  plan.closures[3].status = ClosureStatus::StepLimit;
  plan.closures[4].leak_mm2 = std::numeric_limits<double>::quiet_NaN();
  const RegionReport report = region_report(plan, 5);
  EXPECT_EQ(report.closures, 5);
  EXPECT_EQ(report.failures, 3);
  EXPECT_NEAR(report.leak_mm2.mean, 2.0, kTolerance);
  EXPECT_NEAR(report.leak_mm2.sd, 1.0, kTolerance);
  EXPECT_EQ(report.leak_mm2.below_5, 1.0);
}

TEST(RegionReport, OneTrustedNodeSaysNothingAboutARegion) {
  PlanRecord plan;
  plan.closures = {{0, leaking(0.5)}};
  RegionReport report = region_report(plan, 17);
  EXPECT_EQ(report.leak_mm2.nominal, 0.5);
  expect_unknown(report.leak_mm2);
  expect_unknown(report.independent_leak_mm2);
  EXPECT_TRUE(std::isnan(report.margin_to_leak.suture_length_mm));
  EXPECT_TRUE(std::isnan(report.margin_to_leak.angle_deg));
  EXPECT_TRUE(std::isnan(report.margin_to_leak.share));
  EXPECT_EQ(why_margin_unknown(report), "no error of execution was closed");
  EXPECT_TRUE(std::isnan(report.indices.first[0]));
  EXPECT_TRUE(report.remodelling.empty());
  plan.closures[1] = failed();
  expect_unknown(region_report(plan, 17).leak_mm2);
  EXPECT_TRUE(std::isnan(region_report({}, 17).leak_mm2.nominal));
}

TEST(RegionReport, IndicesShareOutTheVarianceOfAQuadraticLeak) {
  // Variances: 20/3 of length, 10 of an angle, 78 of an angle's square: 9 x 20/3 + 78 + 0.09 x 200/3.
  const RegionReport report = region_report(whole_region(quadratic), kRegion.count);
  EXPECT_NEAR(report.leak_mm2.mean, 60.0, kTolerance);
  EXPECT_NEAR(report.leak_mm2.sd, 12.0, kTolerance);
  EXPECT_NEAR(report.leak_mm2.worst, 93.0, kTolerance);
  EXPECT_NEAR(report.indices.first[0], 60.0 / 144.0, kTolerance);
  EXPECT_NEAR(report.indices.first[1], 78.0 / 144.0, kTolerance);
  EXPECT_NEAR(report.indices.first[2], 0.0, kTolerance);
  EXPECT_NEAR(report.indices.total[0], 66.0 / 144.0, kTolerance);
  EXPECT_NEAR(report.indices.total[1], 78.0 / 144.0, kTolerance);
  EXPECT_NEAR(report.indices.total[2], 6.0 / 144.0, kTolerance);
}

TEST(RegionReport, IndicesTakeTheMeanForAFailedNode) {
  PlanRecord plan = whole_region([](int l, int, int) { return 50.0 + 3.0 * l; });
  plan.closures[region_node(4, 2, 7)] = failed();  // where the leak is the mean anyway
  const RegionIndices indices = region_report(plan, kRegion.count).indices;
  EXPECT_NEAR(indices.first[0], 1.0, kTolerance);
  EXPECT_NEAR(indices.total[0], 1.0, kTolerance);
  EXPECT_NEAR(indices.total[1], 0.0, kTolerance);
}

TEST(RegionReport, IndicesAreUnknownOfAPartOfTheGridOrWhereNothingVaries) {
  PlanRecord plan = whole_region(quadratic);
  EXPECT_TRUE(std::isnan(region_report(plan, 1088).indices.first[0]));
  plan.closures.erase(700);
  EXPECT_TRUE(std::isnan(region_report(plan, kRegion.count).indices.total[1]));
  plan = whole_region([](int, int, int) { return 0.1; });
  plan.closures[700] = failed();
  EXPECT_TRUE(std::isnan(region_report(plan, kRegion.count).indices.first[2]));
  for (auto& [disturbance, closure] : plan.closures) closure = failed();
  EXPECT_TRUE(std::isnan(region_report(plan, kRegion.count).indices.first[2]));
}

TEST(RegionReport, MarginIsHowFarTheFirstLeakLiesOnEachAxis) {
  const auto margin = [](const PlanRecord& plan) {
    return region_report(plan, kRegion.count).margin_to_leak;
  };
  PlanRecord plan = whole_region([](int l, int o, int) { return l >= 3 || o <= -2 ? 1.1 : 1.0; });
  EXPECT_NEAR(margin(plan).suture_length_mm, 0.75, kTolerance);
  EXPECT_NEAR(margin(plan).angle_deg, 2.0, kTolerance);
  EXPECT_NEAR(margin(plan).share, 0.4, kTolerance);
  plan.closures[region_node(4, 5, 6)] = failed();  // 1 degree backwards
  EXPECT_NEAR(margin(plan).angle_deg, 1.0, kTolerance);
  EXPECT_NEAR(margin(plan).share, 0.2, kTolerance);
  // Neither axis alone leaks, both together do.
  plan = whole_region([](int l, int o, int) { return l >= 2 && o >= 3 ? 9.0 : 0.0; });
  EXPECT_NEAR(margin(plan).suture_length_mm, 1.0, kTolerance);
  EXPECT_NEAR(margin(plan).angle_deg, 5.0, kTolerance);
  EXPECT_NEAR(margin(plan).share, 0.6, kTolerance);
}

TEST(RegionReport, AMarginThatIsNotKnownSaysWhy) {
  const PlanRecord plan = whole_region([](int, int, int) { return 0.0; });
  EXPECT_EQ(why_margin_unknown(region_report(plan, kRegion.count)), "");
  PlanRecord angles;
  angles.closures = {{0, leaking(0.0)},
                     {region_node(4, 6, 5), leaking(0.0)},
                     {region_node(5, 6, 6), leaking(0.0)}};
  const RegionReport report = region_report(angles, kRegion.count);
  EXPECT_EQ(why_margin_unknown(report),
            "no error of suture length alone is among the 2 errors of execution closed");
  angles.closures.erase(region_node(4, 6, 5));
  EXPECT_EQ(
      why_margin_unknown(region_report(angles, kRegion.count)),
      "neither an error of suture length alone nor one of angle alone is among the 1 error of "
      "execution closed");
}

TEST(RegionReport, MarginIsAllOfItOrNothing) {
  LeakMargin margin =
      region_report(whole_region([](int, int, int) { return 0.0; }), kRegion.count).margin_to_leak;
  EXPECT_EQ(margin.suture_length_mm, 1.0);
  EXPECT_EQ(margin.angle_deg, 5.0);
  EXPECT_EQ(margin.share, 1.0);
  for (const PlanClosure& planned : {leaking(1.1), failed()}) {
    PlanRecord plan;
    plan.closures[0] = planned;
    margin = region_report(plan, kRegion.count).margin_to_leak;
    EXPECT_EQ(margin.suture_length_mm, 0.0);
    EXPECT_EQ(margin.angle_deg, 0.0);
    EXPECT_EQ(margin.share, 0.0);
  }
}

TEST(RegionReport, TheMapOfBothMusclesIsTheMeanOverAnglesBackwards) {
  PlanRecord plan = whole_region(quadratic);
  for (int p = 0; p < kRegionAngles; ++p) plan.closures[region_node(0, 0, p)] = failed();
  plan.closures.erase(region_node(8, 10, 0));
  const std::vector<LeakMap> maps = region_report(plan, kRegion.count).maps;
  ASSERT_EQ(maps.size(), 1u);
  EXPECT_EQ(maps[0].muscle, "both");
  ASSERT_EQ(maps[0].leak_mm2.size(), 9u);
  for (std::size_t l = 0; l < 9; ++l) {
    ASSERT_EQ(maps[0].leak_mm2[l].size(), 11u);
    for (std::size_t o = 0; o < 11; ++o) {
      const double length = static_cast<double>(l) - 4.0, outwards = static_cast<double>(o) - 5.0;
      if (l == 0 && o == 0)
        EXPECT_TRUE(std::isnan(maps[0].leak_mm2[l][o]));
      else if (l == 8 && o == 10)  // without -5: the mean of the other angles is 0.5
        EXPECT_NEAR(maps[0].leak_mm2[l][o], 50.0 + 12.0 + 25.0 + 0.3 * 4.0 * 0.5, kTolerance);
      else
        EXPECT_NEAR(maps[0].leak_mm2[l][o], 50.0 + 3.0 * length + outwards * outwards, kTolerance);
    }
  }
}

TEST(RegionReport, ASuturedMuscleHasAMapOfItsOwnWhereItWasClosed) {
  PlanRecord plan;
  plan.plan.steps = {PapillaryApproximation{.side = Side::Posteromedial}};
  plan.closures[0] = leaking(7.0);
  EXPECT_EQ(region_report(plan, 1).maps.size(), 1u);
  plan.closures[slice_node(Side::Anterolateral, 0, 0)] = leaking(1.0);  // has no suture
  EXPECT_EQ(region_report(plan, 1).maps.size(), 1u);
  plan.closures[slice_node(Side::Posteromedial, 8, 2)] = leaking(3.0);
  const std::vector<LeakMap> maps = region_report(plan, 1).maps;
  ASSERT_EQ(maps.size(), 2u);
  EXPECT_EQ(maps[1].muscle, "posteromedial");
  EXPECT_EQ(maps[1].leak_mm2[8][2], 3.0);
  EXPECT_EQ(maps[1].leak_mm2[4][5], 7.0);  // as planned
  EXPECT_TRUE(std::isnan(maps[1].leak_mm2[0][0]));
}

TEST(RegionReport, RemodellingIsOneCurveADirection) {
  PlanRecord plan;
  plan.closures[0] = leaking(0.0);
  for (std::size_t ray = 0; ray < 4; ++ray)
    for (std::size_t mm = 1; mm <= 6; ++mm)
      plan.closures[remodelling_rays()[ray].indices[mm]] =
          leaking(static_cast<double>(10 * ray + mm));
  plan.closures[remodelling_rays()[1].indices[4]] = failed();
  plan.closures.erase(remodelling_rays()[2].indices[6]);
  const std::vector<RemodellingCurve> curves = region_report(plan, 1).remodelling;
  ASSERT_EQ(curves.size(), 4u);
  EXPECT_EQ(curves[0].direction, "apical");
  EXPECT_EQ(curves[0].leak_mm2, (std::vector<double>{0, 1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(curves[1].leak_mm2[3], 13.0);
  EXPECT_TRUE(std::isnan(curves[1].leak_mm2[4]));
  EXPECT_TRUE(std::isnan(curves[2].leak_mm2[6]));
  EXPECT_EQ(curves[3].direction, "all three");
}

TEST(RegionReport, IndependentErrorsHaveStatisticsOfTheirOwn) {
  PlanRecord plan;
  plan.closures[0] = leaking(0.0);
  plan.closures[1] = leaking(100.0);
  plan.closures[kIndependent.first] = leaking(6.0);
  plan.closures[kIndependent.first + 1] = failed();
  plan.closures[kIndependent.first + kIndependent.count - 1] = leaking(12.0);
  const LeakStatistics leak = region_report(plan, kRegion.count).independent_leak_mm2;
  EXPECT_EQ(leak.nominal, 0.0);
  EXPECT_NEAR(leak.mean, 6.0, kTolerance);
  EXPECT_NEAR(leak.sd, std::sqrt(24.0), kTolerance);
  EXPECT_EQ(leak.worst, 12.0);
}

}  // namespace
}  // namespace coapt
